#pragma once

#include <insonate/core/Vec3.h>
#include <insonate/image/Volume.h>

namespace insonate {

/// Direction in which a structure is longest on one side of the midline (first principal axis of its voxels), unit,
/// patient LPS, pointing headward. Cranio-caudal where the structure is missing.
Vec3 fibreAxis(const LabelMap& labels, std::uint8_t label, double midline_mm, bool rightSide);

}  // namespace insonate
