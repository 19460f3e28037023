#pragma once

#include "scene/CaseFacts.h"
#include "scene/NodeLattice.h"

#include <cstdint>
#include <span>

namespace insonate {

/// Computes the most probable label of each node of a box, [node]. Between slices of unequal spacing, outlines are
/// blended linearly.
void labelsOfNodes(const LabelMap& labels, const NodeLattice& lattice, const NodeBox& box, std::span<std::uint8_t> out);

/// Computes the deviation of the CT from the mean of each structure at each node of a box, HU, [node].
void deviationsOfNodes(const CtVolume& ct, const LabelMap& labels, const LabelMeans& mean_HU,
                       const NodeLattice& lattice, const NodeBox& box, std::span<std::int16_t> out);

}  // namespace insonate
