#include "color/ColorRegistry.h"

#include "auto/AutoEngine.h"

namespace insonate {

void ColorFrame::resize(int newLines, int newGates) {
  lines = newLines, gates = newGates;
  const std::size_t count = std::size_t(lines) * gates;
  power.resize(count), lagOneRe.resize(count), lagOneIm.resize(count);
}

std::vector<std::string> colorDopplerNames() {
  return {"reference", "cpu", "glsl"};
}

Result<std::unique_ptr<ColorDoppler>> makeColorDoppler(std::string_view name) {
  if (name == "reference") return makeReferenceColor();
  if (name == "cpu") return makeCpuColor();
  if (name == "glsl") return makeGlslColor();
  if (name == "auto") {
    // As for images, an engine that can no longer be made is replaced by the one of the processor.
    auto chosen = makeColorDoppler(automaticChoice().name);
    return chosen ? std::move(chosen) : makeCpuColor();
  }
  return fail("There is no engine \"" + std::string(name) + "\"; choose auto, reference, cpu or glsl.");
}

}  // namespace insonate
