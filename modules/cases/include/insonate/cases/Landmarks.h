#pragma once

#include <insonate/cases/PatientCase.h>

#include <span>
#include <string_view>

namespace insonate {

/// A kind of anatomical landmark, to which instructions for trainees refer.
struct LandmarkKind {
  std::string_view code;  ///< code of the landmark in case.json, e.g. "cricoid"
  std::string_view name;
  bool onSkin;  ///< true if the landmark lies on the skin, false if below the skin
};

/// Returns the kinds of landmarks, in the order in which forms list them.
std::span<const LandmarkKind> landmarkKinds();

/// Returns the landmark kind with this code; null if the code is unknown.
const LandmarkKind* landmarkKind(std::string_view code);

}  // namespace insonate
