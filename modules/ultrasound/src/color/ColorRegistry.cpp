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
  if (name == "auto") return makeColorDoppler(automaticChoice().name);
  return fail("There is no engine \"" + std::string(name) + "\"; choose auto, reference, cpu or glsl.");
}

}  // namespace insonate
