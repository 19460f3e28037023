#pragma once

#include <insonate/cases/PatientCase.h>

#include <span>
#include <string_view>

namespace insonate {

/// A place on every neck that instructions to a trainee refer to.
struct LandmarkKind {
  std::string_view code;  ///< as in case.json, e.g. "cricoid"
  std::string_view name;
  bool onSkin;  ///< lies on the skin, not below it
};

/// Kinds of landmarks, in the order of a form.
std::span<const LandmarkKind> landmarkKinds();

/// Kind of a code; null if the code is unknown.
const LandmarkKind* landmarkKind(std::string_view code);

}  // namespace insonate
