#include "WebRig.h"

#include <insonate/tissue/Labels.h>
#include <insonate/views/Theme.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace insonate::test {
namespace {

using ::testing::HasSubstr;
using views::Color;

/// Colors of the variables in the block of the style sheet that begins at `from`.
std::map<std::string, Color> paletteIn(const std::string& style, std::size_t from) {
  std::map<std::string, Color> colors;
  const std::string block = style.substr(from, style.find('}', from) - from);
  for (std::size_t at = block.find("--"); at != std::string::npos; at = block.find("--", at + 2)) {
    const std::size_t colon = block.find(':', at);
    std::string digits = block.substr(colon + 3, block.find(';', colon) - colon - 3);
    if (digits.size() == 3) digits = {digits[0], digits[0], digits[1], digits[1], digits[2], digits[2]};
    const auto value = static_cast<unsigned>(std::stoul(digits, nullptr, 16));
    colors[block.substr(at + 2, colon - at - 2)] = {std::uint8_t(value >> 16), std::uint8_t(value >> 8),
                                                    std::uint8_t(value)};
  }
  return colors;
}

/// Relative luminance and contrast as WCAG 2.2 defines them.
double luminance(Color color) {
  const auto linear = [](std::uint8_t part) {
    const double share = part / 255.0;
    return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.red) + 0.7152 * linear(color.green) + 0.0722 * linear(color.blue);
}
double contrast(Color a, Color b) {
  const auto [low, high] = std::minmax({luminance(a), luminance(b)});
  return (high + 0.05) / (low + 0.05);
}

class WebPalette : public ::testing::Test {
 protected:
  StoreRig rig;
  const WebSchool school{rig.open()};
  const std::string style = school.get("/style.css").body;
};

TEST_F(WebPalette, DarkPagesHaveTheColorsOfTheWindow) {
  namespace theme = views::theme;
  auto dark = paletteIn(style, style.find(":root {"));
  const std::map<std::string, Color> window{
      {"ground", theme::kGround},   {"panel", theme::kPanel}, {"line", theme::kLine},     {"text", theme::kText},
      {"quiet", theme::kQuiet},     {"link", theme::kLink},   {"accent", theme::kAccent}, {"good", theme::kGood},
      {"caution", theme::kCaution}, {"bad", theme::kDanger}};
  EXPECT_EQ(dark.size(), window.size());
  for (const auto& [name, color] : window) EXPECT_TRUE(dark[name] == color) << name;
}

TEST_F(WebPalette, TextIsLegibleOnAllBackgroundsAndMarksAreVisible) {
  const std::size_t light = style.find("prefers-color-scheme: light"), print = style.find("@media print");
  for (const std::size_t block : {style.find(":root {"), style.find(":root {", light), style.find(":root {", print)}) {
    ASSERT_NE(block, std::string::npos);
    auto colors = paletteIn(style, block);
    for (const char* ground : {"ground", "panel"}) {
      for (const char* words : {"text", "quiet", "link", "good", "bad"})
        EXPECT_GE(contrast(colors[words], colors[ground]), 4.5) << words << " on " << ground << " at " << block;
      for (const char* mark : {"accent", "caution"})
        EXPECT_GE(contrast(colors[mark], colors[ground]), 3) << mark << " on " << ground << " at " << block;
    }
  }
}

TEST_F(WebPalette, StructuresHaveTheColorsOfTheLabelTable) {
  for (const auto& [kind, label] : {std::pair{"vein", kVein}, {"artery", kArtery}, {"skin", kSkin}}) {
    const auto& color = labelTable()[label].color;
    EXPECT_THAT(style, HasSubstr(std::string(".structure.") + kind + "{fill:rgb(" + std::to_string(color[0]) + "," +
                                 std::to_string(color[1]) + "," + std::to_string(color[2]) + ")}"));
  }
}

}  // namespace
}  // namespace insonate::test
