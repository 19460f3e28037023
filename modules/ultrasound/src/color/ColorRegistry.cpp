#include "color/ColorRegistry.h"

namespace insonate {

void ColorFrame::resize(int newLines, int newGates) {
  lines = newLines, gates = newGates;
  const std::size_t count = std::size_t(lines) * gates;
  power.resize(count), lagOneRe.resize(count), lagOneIm.resize(count);
}

std::vector<std::string> colorDopplerNames() {
  return {"reference", "cpu"};
}

Result<std::unique_ptr<ColorDoppler>> makeColorDoppler(std::string_view name) {
  if (name == "reference") return makeReferenceColor();
  // A graphics card computes the B-mode image only; color takes a small part of the time of a frame.
  if (name == "cpu" || name == "glsl" || name == "auto") return makeCpuColor();
  return fail("There is no engine \"" + std::string(name) + "\"; choose auto, reference, cpu or glsl.");
}

}  // namespace insonate
