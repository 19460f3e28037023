#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/core/Transform.h>
#include <insonate/surface/Mesh.h>

namespace insonate {

/// Removes waves shorter than `wavelength_mm` from a closed mesh with a windowed sinc: a low-pass filter that keeps
/// longer waves and the volume (Taubin, Zhang, Golub, "Optimal surface smoothing as filter design", ECCV 1996). No
/// point moves by more than half a grid step along any axis (as in Gibson's surface nets, 1998). A part of the mesh
/// that is too small to be smoothed keeps its shape. Reports progress with the text `doing`, from `from` to `to`.
Result<void> smoothMesh(Mesh& mesh, double wavelength_mm, const Transform& indexFromPatient, const Progress& progress,
                        std::string_view doing, double from, double to);

}  // namespace insonate
