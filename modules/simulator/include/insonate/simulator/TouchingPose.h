#pragma once

#include <insonate/cases/PlaceProposal.h>

namespace insonate {

/// Contact of the probe `linear` with the skin at a pose of a case, with the tissue values of the preset `measured` and
/// the blood pressures of the CT.
struct ProbeTouch {
  /// Maximum gap between face and skin that gel fills, as far as the pose counts as touching there.
  static constexpr double kGel_mm = 2;
  static constexpr double kMinTouching = 0.9, kMaxForce_N = 2, kMinVein = 0.9;

  double touching = 0;  ///< share of the array's width at which the gap is at most kGel_mm
  double force_N = 0;   ///< contact force
  double vein = 1;      ///< area of the veins in the image plane as a share of that in the CT; 1 without veins

  /// Tells whether the probe touches without compressing the vein: all three values are within the limits above.
  bool isLight() const { return touching >= kMinTouching && force_N <= kMaxForce_N && vein >= kMinVein; }
};

/// Measures the contact at a pose. Takes some seconds. Fails if the image would lie outside the case's volume, and if
/// CT and labels have different grids.
Result<ProbeTouch> touchAt(const CaseView& patient, const StartPose& pose);

/// Proposes the places that a case lacks (proposePlaces()), with start poses at which the probe touches without
/// compressing the vein (ProbeTouch::isLight()). A flat face meets a curved neck only with its ends or its middle, and
/// must then be pressed on until the vein collapses. Each proposed pose is therefore turned about its target (up to 30
/// degrees around the vessel, 20 degrees in the image plane, 8 degrees about the beam), slid by up to 12 mm along the
/// image, and indented by no more than the contact needs. The nearest pose that is light is taken; a note names each
/// pose for which there is none, and the pose with the best contact is then proposed. Takes some seconds for each
/// target. Fails as proposePlaces() does.
Result<PlaceProposal> proposeTouchingPlaces(const CaseView& patient, const Progress& progress = {});

}  // namespace insonate
