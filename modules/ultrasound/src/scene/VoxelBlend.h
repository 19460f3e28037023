#pragma once

#include "scene/CaseFacts.h"
#include "scene/NodeLattice.h"

#include <cstdint>
#include <span>

namespace insonate {

/// Most likely label of each node of a box; between slices of unlike spacing this is a linear blend of their outlines.
/// [node of the box]
void labelsOfNodes(const LabelMap& labels, const NodeLattice& lattice, const NodeBox& box, std::span<std::uint8_t> out);

/// Deviation of the CT from the mean of its structures, HU. [node of the box]
void deviationsOfNodes(const CtVolume& ct, const LabelMap& labels, const LabelMeans& mean_HU,
                       const NodeLattice& lattice, const NodeBox& box, std::span<std::int16_t> out);

}  // namespace insonate
