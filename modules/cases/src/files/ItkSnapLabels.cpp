#include "ItkSnapLabels.h"

#include <insonate/tissue/Labels.h>

#include <array>
#include <cstdio>

namespace insonate {
namespace {

std::string line(int label, const std::array<std::uint8_t, 3>& colour, int visible, const std::string& name) {
  std::array<char, 160> text;
  std::snprintf(text.data(), text.size(), "%5d %5d %4d %4d %8d %2d %2d    \"%.80s\"\n", label, colour[0], colour[1],
                colour[2], visible, visible, visible, name.c_str());
  return text.data();
}

}  // namespace

std::string itkSnapLabelText(const LabelMap& labels, const LabelColours& colours) {
  std::array<bool, 256> used{};
  for (const std::uint8_t v : labels.voxels) used[v] = true;
  const std::string rule = "################################################\n";
  std::string text = rule +
                     "# ITK-SnAP Label Description File\n"
                     "# File format: \n"
                     "# IDX   -R-  -G-  -B-  -A--  VIS MSH  LABEL\n"
                     "# Fields: \n"
                     "#    IDX:   Zero-based index \n"
                     "#    -R-:   Red color component (0..255)\n"
                     "#    -G-:   Green color component (0..255)\n"
                     "#    -B-:   Blue color component (0..255)\n"
                     "#    -A-:   Label transparency (0.00 .. 1.00)\n"
                     "#    VIS:   Label visibility (0 or 1)\n"
                     "#    MSH:   Label mesh visibility (0 or 1)\n"
                     "#  LABEL:   Label description \n" +
                     rule + line(0, {0, 0, 0}, 0, "Clear Label");
  for (const LabelInfo& info : labelTable())
    if (info.label != kBackground) text += line(info.label, colourOf(colours, info.label), 1, std::string(info.name));
  for (int label = kLabelCount; label < 256; ++label)
    if (used[label])
      text += line(label, colourOf(colours, static_cast<std::uint8_t>(label)), 1, "label " + std::to_string(label));
  return text;
}

}  // namespace insonate
