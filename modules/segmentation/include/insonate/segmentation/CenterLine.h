#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace insonate {

/// Center line of an unbranched piece of a vessel, from one end to the other: the centroids of its cross-sections,
/// about a millimeter apart. Patient space, mm.
using CenterLine = std::vector<Vec3>;

/// Returns the center lines of all vessels with this label. The direction of each line is arbitrary. At a confluence,
/// one line continues and the other lines end near it. A vessel that ends at the volume's edge has a line up to the
/// edge; a piece of a vessel that is shorter than wide has no line. Grids may be anisotropic, oblique, of either
/// handedness. The same label map always gives the same lines. Fails on an invalid grid, and when cancelled; a label
/// without voxels gives no lines.
Result<std::vector<CenterLine>> centerLines(const LabelMap& labels, std::uint8_t label, const Progress& progress = {});

/// Returns the distance from a point to the nearest of these center lines, mm; no value if there are no lines. Neither
/// waits nor allocates.
std::optional<double> distanceToCenterLine_mm(std::span<const CenterLine> lines, Vec3 patient_mm) noexcept;

}  // namespace insonate
