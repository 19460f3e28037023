#include <insonate/tissue/Labels.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace insonate {
namespace {

TEST(Labels, TheThesisNumbersNeverChange) {
  EXPECT_EQ(kBackground, 0);
  EXPECT_EQ(kArtery, 2);
  EXPECT_EQ(kAirway, 4);
  EXPECT_EQ(kVein, 6);
  EXPECT_EQ(kThyroid, 8);
  EXPECT_EQ(kSternocleidomastoid, 10);
  EXPECT_EQ(kBone, 12);
  EXPECT_EQ(kSoftTissue, 14);
}

TEST(Labels, EachRowOfTheTableStandsAtItsNumber) {
  for (std::size_t i = 0; i < labelTable().size(); ++i) EXPECT_EQ(labelTable()[i].label, i);
}

TEST(Labels, NamesAreUniqueAndLeadBackToTheirLabel) {
  std::set<std::string_view> names;
  for (const LabelInfo& info : labelTable()) {
    EXPECT_FALSE(info.name.empty());
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_EQ(labelFromName(info.name), info.label);
  }
}

TEST(Labels, AnUnknownNameIsNoLabel) {
  EXPECT_EQ(labelFromName("spleen"), std::nullopt);
  EXPECT_EQ(labelFromName(""), std::nullopt);
  EXPECT_EQ(labelFromName("Vein"), std::nullopt);
}

TEST(Labels, EveryStructureHasASnomedCode) {
  for (const LabelInfo& info : labelTable()) {
    if (info.label == kBackground) continue;
    EXPECT_GE(info.snomedCode.size(), 6U) << info.name;
    EXPECT_TRUE(std::ranges::all_of(info.snomedCode, [](char c) { return c >= '0' && c <= '9'; })) << info.name;
    EXPECT_FALSE(info.snomedMeaning.empty()) << info.name;
  }
}

TEST(Labels, AnUnknownLabelIsNamedByItsNumber) {
  EXPECT_EQ(labelName(kVein), "vein");
  EXPECT_EQ(labelName(47), "label 47");
}

TEST(Labels, VeinAndArteryLookDifferent) {
  EXPECT_NE(labelTable()[kVein].color, labelTable()[kArtery].color);
}

}  // namespace
}  // namespace insonate
