#pragma once

#include "scene/TissueField.h"

#include <insonate/core/Progress.h>

namespace insonate {

/// Fills field.distance from the label of each node: Euclidean distance to each structure within the reach, negative
/// inside, smoothed by Gaussians of the given SD along each axis without moving an outline by more than `freedom_mm`.
/// False when cancelled.
bool signedDistances(const std::vector<std::uint8_t>& nodeLabel, Vec3 nodeSpacing_mm, Vec3 smoothing_mm,
                     float freedom_mm, TissueField& field, const Progress& progress);

}  // namespace insonate
