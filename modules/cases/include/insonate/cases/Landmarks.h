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

/// In the order in which a form lists them.
std::span<const LandmarkKind> landmarkKinds();

/// Null for a code that is not known here.
const LandmarkKind* landmarkKind(std::string_view code);

}  // namespace insonate
