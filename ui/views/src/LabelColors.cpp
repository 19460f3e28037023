#include <insonate/tissue/Labels.h>
#include <insonate/views/LabelColors.h>

#include <array>

namespace insonate::views {
namespace {

// Colors of Okabe and Ito (jfly.uni-koeln.de/color, 2008) for the structures that trainees look at; Tol's dark colors
// (personal.sron.nl/~pault, 2021) and grays for the others. Vein and artery are blue and vermilion.
constexpr std::array<Color, kLabelCount> kSafe{{
    {0x00, 0x00, 0x00},  // background
    {0xbf, 0xb5, 0xae},  // skin
    {0xd5, 0x5e, 0x00},  // artery
    {0xf7, 0xf1, 0xb5},  // fat
    {0x56, 0xb4, 0xe9},  // airway and lung
    {0xf0, 0xe4, 0x42},  // nerve
    {0x00, 0x72, 0xb2},  // vein
    {0xe6, 0x9f, 0x00},  // lymph node
    {0xcc, 0x79, 0xa7},  // thyroid
    {0x66, 0x11, 0x00},  // esophagus
    {0x00, 0x9e, 0x73},  // sternocleidomastoid
    {0x00, 0x66, 0x4b},  // muscle
    {0xf4, 0xf1, 0xea},  // bone
    {0xbb, 0xcc, 0xee},  // cartilage
    {0x6b, 0x6b, 0x6b},  // soft tissue
    {0x33, 0x22, 0x88},  // salivary gland
}};

}  // namespace

Color labelColor(std::uint8_t label, ColorScheme scheme) {
  const Label known = knownLabel(label);
  if (scheme == ColorScheme::ColorBlindSafe) return kSafe[known];
  const auto& usual = labelTable()[known].color;
  return {usual[0], usual[1], usual[2]};
}

double defaultOpacity(std::uint8_t label) {
  return label == kSkin ? 0.35 : 1;
}

}  // namespace insonate::views
