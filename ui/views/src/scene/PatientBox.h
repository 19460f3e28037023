#pragma once

#include "SceneState.h"

#include <span>

namespace insonate::views {

/// Boxes are in VTK's order: x low, x high, ...

/// Box of all surfaces, hidden ones too, or without any of the CT. False if there is nothing.
bool patientBox(const SceneState& state, const VtkCase* patient, double box[6]);

/// The CT's box.
void ctBox(const VtkCase& patient, double box[6]);

/// Box of points, x y z each.
void pointsBox(std::span<const float> points_mm, double box[6]);

}  // namespace insonate::views
