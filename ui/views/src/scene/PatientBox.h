#pragma once

#include "SceneState.h"

#include <span>

namespace insonate::views {

/// Boxes are in VTK's order: x low, x high, ...

/// Computes the box of all surfaces, including hidden ones, or of the CT if there are no surfaces. Returns false if
/// there is neither.
bool patientBox(const SceneState& state, const VtkCase* patient, double box[6]);

/// Computes the box of the CT.
void ctBox(const VtkCase& patient, double box[6]);

/// Computes the box of points given as x, y, z each.
void pointsBox(std::span<const float> points_mm, double box[6]);

}  // namespace insonate::views
