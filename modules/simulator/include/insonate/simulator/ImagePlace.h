#pragma once

#include <insonate/simulator/LiveImaging.h>

namespace insonate {

/// Distance by which a corner of the image plane may lie beside its place in an image of the same position. A hand that
/// moves the probe is ahead of its image by less.
inline constexpr double kSamePlace_mm = 15;

/// Tells whether an image shows the tissue in front of a probe at this pose: no corner of the image lies more than
/// kSamePlace_mm from the place that it has at the pose.
bool showsPlaceOf(const LiveFrame& frame, const Transform& patientFromProbe);

}  // namespace insonate
