#pragma once

#include <insonate/ultrasound/Engine.h>

#include <memory>

namespace insonate {

/// Fails with a sentence where there is no OpenGL 4.3. Where the card fails later, frames come from the `cpu` engine,
/// and note() says why.
Result<std::unique_ptr<Engine>> makeGlslEngine();

namespace glsl {
class Device;
/// Makes an engine on a given device.
std::unique_ptr<Engine> makeEngineOn(std::shared_ptr<const Device> device);
}  // namespace glsl

}  // namespace insonate
