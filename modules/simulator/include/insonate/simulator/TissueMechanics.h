#pragma once

#include <insonate/deformation/DeformationModel.h>
#include <insonate/ultrasound/ImagingSettings.h>

#include <string>
#include <string_view>

namespace insonate {

/// Value of TissueMechanics::model for tissue that is never displaced: the image of a probe below the skin shows
/// undeformed tissue.
inline constexpr std::string_view kNoDeformation = "none";

/// Returns the preset `measured` of tissue mechanics.
const MechanicalTable& measuredMechanics();

/// Mechanical model of the tissue under the probe. Blood pressure is set separately (Physiology.h).
struct TissueMechanics {
  std::string model = "elastic";  ///< kNoDeformation, or one of deformationModelNames()
  MechanicalTable tissues = measuredMechanics();
  double footprint_mm = 10;  ///< width of the probe's housing in elevation, which distributes the force; 1 to 100
  bool sticking = false;     ///< true: tissue under the probe's face does not slide along the face
  DeformationSettings settings;
};
bool operator==(const TissueMechanics& a, const TissueMechanics& b);

/// Fails with a sentence on an unknown model or on values out of range.
Result<void> validate(const TissueMechanics& mechanics);

/// Returns the face of a probe's housing in the image plane, which touches the skin. At each end, it extends by
/// Probe::faceMargin_mm beyond the array, which determines the width of the image. Linear: flat. Curvilinear: the arc
/// of the array, continued. Phased: flat and wider than the aperture, although the fan begins in a point.
ProbeFace probeFaceOf(const Probe& probe, const TissueMechanics& mechanics);

/// Rectangle of the image plane, in the probe frame, in which the deformation of tissue is computed. Tissue outside has
/// the displacement of the nearest edge.
struct DeformationWindow {
  double half_mm = 0;  ///< lateral extent to either side of the probe's axis
  double top_mm = 0, bottom_mm = 0;
  bool operator==(const DeformationWindow&) const = default;
};
DeformationWindow deformationWindow(const Probe& probe, const ImagingSettings& settings,
                                    const TissueMechanics& mechanics);

}  // namespace insonate
