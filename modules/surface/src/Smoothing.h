#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/core/Transform.h>
#include <insonate/surface/Mesh.h>

namespace insonate {

/// Removes waves shorter than `wavelength_mm` from a closed mesh with a windowed sinc: a low-pass filter that keeps
/// longer waves and the volume (Taubin, Zhang, Golub, "Optimal surface smoothing as filter design", ECCV 1996). No
/// point moves by more than half an index along an axis of the grid (as in Gibson's surface nets, 1998). A part of the
/// mesh that is too small to be smoothed keeps its shape.
Result<void> smoothMesh(Mesh& mesh, double wavelength_mm, const Transform& indexFromPatient, const Progress& progress,
                        std::string_view doing, double from, double to);

}  // namespace insonate
