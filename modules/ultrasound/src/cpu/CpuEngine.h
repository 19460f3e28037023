#pragma once

#include <insonate/ultrasound/Engine.h>

namespace insonate {

/// The model of the reference engine with SIMD across scanlines and threads across blocks of them, in float.
std::unique_ptr<Engine> makeCpuEngine();

}  // namespace insonate
