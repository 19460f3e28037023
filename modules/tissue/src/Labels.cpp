#include <insonate/tissue/Labels.h>

namespace insonate {

const std::array<LabelInfo, kLabelCount>& labelTable() {
  // Colors and codes: 3D Slicer's GeneralAnatomy table and SNOMED CT. Its colors of artery and muscle are nearly equal;
  // here, the artery is redder and the muscle darker, so that color-blind users can tell them apart, too.
  static constexpr std::array<LabelInfo, kLabelCount> kTable{{
      {kBackground, "background", {0, 0, 0}, "", ""},
      {kSkin, "skin", {177, 122, 101}, "39937001", "Skin"},
      {kArtery, "artery", {238, 60, 44}, "51114001", "Artery"},
      {kFat, "fat", {230, 220, 70}, "256674009", "Fat"},
      {kAirway, "airway and lung", {182, 228, 255}, "44567001", "Trachea"},
      {kNerve, "nerve", {244, 214, 49}, "3057000", "Nerve"},
      {kVein, "vein", {0, 151, 206}, "29092000", "Vein"},
      {kLymphNode, "lymph node", {68, 172, 100}, "59441001", "Lymph node"},
      {kThyroid, "thyroid", {62, 162, 114}, "69748006", "Thyroid"},
      {kOesophagus, "oesophagus", {211, 171, 143}, "32849002", "Esophagus"},
      {kSternocleidomastoid, "sternocleidomastoid", {120, 72, 66}, "22823000", "Sternocleidomastoid muscle"},
      {kMuscle, "muscle", {120, 72, 66}, "71616004", "Skeletal muscle"},
      {kBone, "bone", {241, 214, 145}, "272673000", "Bone"},
      {kCartilage, "cartilage", {111, 184, 210}, "61496007", "Cartilage"},
      {kSoftTissue, "soft tissue", {222, 198, 101}, "87784001", "Soft tissue"},
      {kGland, "salivary gland", {185, 135, 134}, "385294005", "Salivary gland"},
  }};
  return kTable;
}

std::string labelName(std::uint8_t label) {
  return label < kLabelCount ? std::string(labelTable()[label].name) : "label " + std::to_string(label);
}

std::optional<Label> labelFromName(std::string_view name) {
  for (const LabelInfo& info : labelTable())
    if (info.name == name) return info.label;
  return std::nullopt;
}

}  // namespace insonate
