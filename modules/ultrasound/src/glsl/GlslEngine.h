#pragma once

#include <insonate/ultrasound/Engine.h>

#include <memory>

namespace insonate {

/// Makes the engine. Fails with a sentence if OpenGL 4.3 is not available. If the card fails later, the `cpu` engine
/// renders the frames, and note() says why.
Result<std::unique_ptr<Engine>> makeGlslEngine();

namespace glsl {
class Device;
/// Makes an engine on a given device.
std::unique_ptr<Engine> makeEngineOn(std::shared_ptr<const Device> device);
}  // namespace glsl

}  // namespace insonate
