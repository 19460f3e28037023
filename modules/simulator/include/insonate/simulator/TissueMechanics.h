#pragma once

#include <insonate/deformation/DeformationModel.h>
#include <insonate/ultrasound/ImagingSettings.h>

#include <string>
#include <string_view>

namespace insonate {

/// Tissue that does not give way: a face inside it shows what lies there at rest.
inline constexpr std::string_view kNoDeformation = "none";

/// The preset `measured`.
const MechanicalTable& measuredMechanics();

/// Mechanical model of the tissue under the probe. Blood pressure is not part of it: it is the patient's present state
/// (Physiology.h).
struct TissueMechanics {
  std::string model = "elastic";  ///< kNoDeformation, or one of deformationModelNames()
  MechanicalTable tissues = measuredMechanics();
  double footprint_mm = 10;  ///< of the housing across the slice, over which a force is spread; 1..100
  bool sticking = false;     ///< tissue under the face does not slide along it
  DeformationSettings settings;
};
bool operator==(const TissueMechanics& a, const TissueMechanics& b);

/// Fails with a sentence on an unknown model and on values out of range.
Result<void> validate(const TissueMechanics& mechanics);

/// Part of a probe that touches the skin, in its plane. Linear: the array's width, flat. Curvilinear: the arc of the
/// array, of radius r1 and as long as the fan is wide at the face. Phased: flat and as wide as its aperture: its fan
/// begins in a point, the housing does not.
ProbeFace faceOf(const Probe& probe, const TissueMechanics& mechanics);

/// Part of the plane, in the probe frame, whose tissue is part of the mechanical model: beyond it, the outermost
/// tissue continues.
struct PressWindow {
  double half_mm = 0;  ///< either side of the axis
  double top_mm = 0, bottom_mm = 0;
  bool operator==(const PressWindow&) const = default;
};
PressWindow pressWindow(const Probe& probe, const ImagingSettings& settings, const TissueMechanics& mechanics);

}  // namespace insonate
