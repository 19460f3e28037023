#include "ItkSnapLabels.h"

#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace insonate {
namespace {

std::string line(int label, const std::array<std::uint8_t, 3>& color, int visible, const std::string& name) {
  std::array<char, 160> text;
  std::snprintf(text.data(), text.size(), "%5d %5d %4d %4d %8d %2d %2d    \"%.80s\"\n", label, color[0], color[1],
                color[2], visible, visible, visible, name.c_str());
  return text.data();
}

}  // namespace

std::string itkSnapLabelText(const PatientCase& patient) {
  std::array<bool, 256> used{};
  for (const std::uint8_t v : patient.labels.voxels) used[v] = true;
  const OwnLabels& own = patient.manifest.ownLabels;
  for (const auto& [label, meaning] : own) used[label] = true;
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
    if (info.label != kBackground)
      text += line(info.label, caseLabelColor(patient.colors, info.label), 1, std::string(info.name));
  for (int number = kLabelCount; number < 256; ++number) {
    const auto label = static_cast<std::uint8_t>(number);
    if (used[label]) text += line(label, caseLabelColor(patient.colors, label), 1, labelName(own, label));
  }
  return text;
}

Result<std::map<std::int32_t, ItkSnapLabel>> readItkSnapLabels(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) return fail("Could not read the label description " + file.string() + ".");
  std::map<std::int32_t, ItkSnapLabel> labels;
  std::string text;
  for (int number = 1; std::getline(in, text); ++number) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string::npos || text[first] == '#') continue;
    std::istringstream words(text);
    std::int32_t index = 0;
    std::array<int, 3> color{};
    double alpha = 0;
    int visible = 0, mesh = 0;
    words >> index >> color[0] >> color[1] >> color[2] >> alpha >> visible >> mesh;
    const std::size_t open = text.find('"'), close = text.rfind('"');
    const bool inRange = std::ranges::all_of(color, [](int part) { return part >= 0 && part <= 255; });
    if (!words || close == open || !inRange)
      return fail("Line " + std::to_string(number) + " of " + file.string() +
                  " is not a label of an ITK-SNAP description: it must have seven numbers and a name in quotes.");
    ItkSnapLabel& label = labels[index];
    label.name = text.substr(open + 1, close - open - 1);
    for (int c = 0; c < 3; ++c) label.color[c] = static_cast<std::uint8_t>(color[c]);
  }
  if (labels.empty()) return fail(file.string() + " describes no labels. Is the file a label description of ITK-SNAP?");
  return labels;
}

}  // namespace insonate
