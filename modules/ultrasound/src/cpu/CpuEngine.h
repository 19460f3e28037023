#pragma once

#include <insonate/ultrasound/Engine.h>

namespace insonate {

/// Makes the engine that computes the reference engine's model in float, with SIMD across scanlines and threads across
/// blocks of scanlines.
std::unique_ptr<Engine> makeCpuEngine();

}  // namespace insonate
