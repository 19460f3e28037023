#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>
#include <insonate/surface/Mesh.h>

#include <cstdint>

namespace insonate {

/// The surface where shares pass one half, in patient LPS, facing out of the larger shares; without normals. Closed
/// when the outermost shares are 0.
Result<Mesh> contour(Volume<std::uint8_t>& share, const Progress& progress, std::string_view doing, double from,
                     double to);

}  // namespace insonate
