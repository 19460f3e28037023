#pragma once

#include <insonate/ultrasound/Engine.h>

#include <memory>

namespace insonate {

/// Makes the engine `glsl`, which renders on a graphics card. Fails with a sentence if OpenGL 4.3 is not available. If
/// the card fails later, the engine `cpu` renders the frames, and note() gives the reason.
Result<std::unique_ptr<Engine>> makeGlslEngine();

namespace glsl {
class Device;
/// Makes an engine `glsl` on a given device, for tests.
std::unique_ptr<Engine> makeEngineOn(std::shared_ptr<const Device> device);
}  // namespace glsl

}  // namespace insonate
