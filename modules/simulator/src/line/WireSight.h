#pragma once

#include "line/LineHands.h"

#include <insonate/image/PlaneDisplacement.h>
#include <insonate/image/Volume.h>
#include <insonate/procedure/TipInView.h>

#include <optional>
#include <span>

namespace insonate {

/// The image plane in which a wire or bubbles are looked for.
struct WirePlane {
  const Transform& patientFromProbe;
  const PlaneDisplacement& displacement;
  const ImageField& field;
  double depth_mm = 0;  ///< depth of the live image
};

/// Finds the views of the wire in the image plane. Short axis: the wire crosses the plane in the field of view, where
/// the vessel meets the plane at more than 45 degrees. Long axis: at least 10 mm of the wire in one piece are visible,
/// as isTipInView() decides, where the vessel lies within 30 degrees of the plane. Neither waits nor allocates.
LineHands::Sight wireSightOf(const WirePlane& plane, const LineHands& line);

/// Counts the bubbles of a flush that the image shows: those in the lumen of the vessel in the case's label map, within
/// half a slice thickness of the plane.
int bubblesIn(const WirePlane& plane, LineHands& line, const LabelMap& labels);

}  // namespace insonate
