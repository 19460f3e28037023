#pragma once

#include <insonate/ultrasound/Instruments.h>
#include <insonate/views/SceneOptions.h>

#include <span>
#include <vector>

namespace insonate::views {

/// Returns guidewires, dilators and catheters as paths: in undeformed tissue, patient space (LPS, mm), as thick as they
/// are, at least 0.5 mm in radius so that a wire is visible.
std::vector<ScenePath> pathsOf(std::span<const FlexibleRod> rods);

}  // namespace insonate::views
