#pragma once

#include <insonate/deformation/DeformationModel.h>
#include <insonate/ultrasound/ImagingSettings.h>

#include <string>
#include <string_view>

namespace insonate {

/// Model of tissue that is not displaced: a face inside the tissue shows the tissue at that place at rest.
inline constexpr std::string_view kNoDeformation = "none";

/// Returns the preset `measured`.
const MechanicalTable& measuredMechanics();

/// Mechanical model of the tissue under the probe. Blood pressure is not part of it: it belongs to the patient's
/// present state (Physiology.h).
struct TissueMechanics {
  std::string model = "elastic";  ///< kNoDeformation, or one of deformationModelNames()
  MechanicalTable tissues = measuredMechanics();
  double footprint_mm = 10;  ///< width of the housing in elevation, over which a force is distributed; 1..100
  bool sticking = false;     ///< tissue under the face does not slide along it
  DeformationSettings settings;
};
bool operator==(const TissueMechanics& a, const TissueMechanics& b);

/// Fails with a sentence on an unknown model or on values out of range.
Result<void> validate(const TissueMechanics& mechanics);

/// Returns the part of a probe that touches the skin, in its plane. Linear: flat, as wide as the array. Curvilinear:
/// the arc of the array, of radius r1 and as long as the fan is wide at the face. Phased: flat and as wide as its
/// aperture, since the housing has a width although the fan begins in a point.
ProbeFace faceOf(const Probe& probe, const TissueMechanics& mechanics);

/// Part of the plane, in the probe frame, whose tissue the mechanical model covers. Beyond it, the outermost tissue
/// continues.
struct PressWindow {
  double half_mm = 0;  ///< extent to either side of the axis
  double top_mm = 0, bottom_mm = 0;
  bool operator==(const PressWindow&) const = default;
};
PressWindow pressWindow(const Probe& probe, const ImagingSettings& settings, const TissueMechanics& mechanics);

}  // namespace insonate
