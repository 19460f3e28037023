#pragma once

#include <insonate/ultrasound/ColorDoppler.h>

namespace insonate {

std::unique_ptr<ColorDoppler> makeReferenceColor();
std::unique_ptr<ColorDoppler> makeCpuColor();
/// Makes color Doppler that runs on a graphics card. Fails with a sentence if OpenGL 4.3 is not available. If the card
/// fails later, `cpu` computes the frames.
Result<std::unique_ptr<ColorDoppler>> makeGlslColor();

namespace glsl {
class Device;
/// Makes color Doppler on a given device, for tests.
std::unique_ptr<ColorDoppler> makeColorOn(std::shared_ptr<const Device> device);
}  // namespace glsl

}  // namespace insonate
