#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace insonate {

/// The middle of a piece of vessel, from one end to the other: the centroids of its cross-sections, about a millimeter
/// apart. Patient space, mm.
using CentreLine = std::vector<Vec3>;

/// Returns the center lines of all vessels with this label, in any direction; where vessels join, one line continues
/// and the others end beside it. A vessel that ends at the volume's edge has its line up to there; pieces shorter than
/// they are wide have none. Grids may be anisotropic, oblique, of either handedness. The same map gives the same
/// lines. Fails on an invalid grid, and when cancelled; a label without voxels gives no lines.
Result<std::vector<CentreLine>> centreLines(const LabelMap& labels, std::uint8_t label, const Progress& progress = {});

/// Distance from a point to the nearest of the lines, mm; empty without a line. Neither waits nor allocates.
std::optional<double> distanceToCentre_mm(std::span<const CentreLine> lines, Vec3 patient_mm) noexcept;

}  // namespace insonate
