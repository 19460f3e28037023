#pragma once

#include <insonate/ultrasound/ColorDoppler.h>

namespace insonate {

std::unique_ptr<ColorDoppler> makeReferenceColor();
std::unique_ptr<ColorDoppler> makeCpuColor();

}  // namespace insonate
