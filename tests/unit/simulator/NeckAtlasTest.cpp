#include <insonate/cases/Phantom.h>
#include <insonate/segmentation/AutoLabel.h>
#include <insonate/segmentation/Score.h>
#include <insonate/simulator/NeckAtlas.h>
#include <insonate/tissue/Labels.h>

#include <gmock/gmock.h>

#include <array>

namespace insonate {
namespace {

using testing::HasSubstr;

/// A built-in neck that the atlas does not contain, with its proposals.
struct ProposedNeck {
  PatientCase truth;
  LabelMap automatic;
  std::vector<AtlasNeck> atlas;
  std::vector<ProposedStructure> found;
};

const ProposedNeck& proposedNeck() {
  static const ProposedNeck kNeck = [] {
    ProposedNeck neck;
    auto truth = makePhantom("small-vein", 3, {}, CtContrast::kArterial);
    EXPECT_TRUE(truth);
    neck.truth = std::move(*truth);
    neck.automatic = *autoLabel(neck.truth.ct, {});
    neck.atlas = *makeNeckAtlas();
    auto found = proposeNeck(neck.truth.ct, neck.automatic, neck.atlas);
    EXPECT_TRUE(found) << found.error().message;
    neck.found = std::move(*found);
    return neck;
  }();
  return kNeck;
}

/// Mean distance of the points of a true vessel from the line, at the levels of the line.
double distance_mm(const NamedVessel& truth, const CenterLine& line) {
  double sum = 0, count = 0;
  for (const NamedVessel::Point& point : truth.course)
    if (point.position_mm.z > line.front().z && point.position_mm.z < line.back().z)
      sum += *distanceToCenterLine_mm(std::array{line}, point.position_mm), count += 1;
  return sum / count;
}

TEST(NeckAtlas, VesselsAreFoundAtTheirPlaces) {
  const ProposedNeck& neck = proposedNeck();
  ASSERT_EQ(neck.found.size(), kNeckStructures);
  for (std::size_t n = 0; n < kNeckVessels; ++n) {
    const ProposedStructure& one = neck.found[n];
    const auto truth = std::ranges::find(neck.truth.manifest.vessels, nameOf(one.structure), &NamedVessel::name);
    ASSERT_NE(truth, neck.truth.manifest.vessels.end());
    ASSERT_GT(one.line.size(), 40U) << nameOf(one.structure);
    EXPECT_LT(distance_mm(*truth, one.line), 2) << nameOf(one.structure);
    EXPECT_EQ(one.question.empty(), one.confidence >= kHighConfidence);
  }
}

TEST(NeckAtlas, ThyroidAndMusclesAgreeWithTheReference) {
  const ProposedNeck& neck = proposedNeck();
  LabelMap found(neck.truth.ct.geometry);
  for (std::size_t n = kNeckVessels; n < kNeckStructures; ++n) {
    const Selection& voxels = neck.found[n].voxels;
    for (int k = voxels.box.first[2]; k < voxels.box.end[2]; ++k)
      for (int j = voxels.box.first[1]; j < voxels.box.end[1]; ++j)
        for (int i = voxels.box.first[0]; i < voxels.box.end[0]; ++i)
          if (voxels.isSelected(i, j, k)) found.at(i, j, k) = labelOf(neck.found[n].structure);
  }
  const auto scores = scoreLabels(found, neck.truth.labels, {kThyroid, kSternocleidomastoid});
  ASSERT_TRUE(scores);
  for (const LabelScore& score : *scores) EXPECT_GT(score.dice, 0.8) << labelName(score.label);
}

TEST(NeckAtlas, VeinsAndArteriesDoNotTouch) {
  const ProposedNeck& neck = proposedNeck();
  constexpr std::array<std::array<int, 3>, 4> kNear{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  std::size_t touching = 0;
  const auto& size = neck.truth.ct.geometry.size;
  const auto isIn = [&](Label label, int i, int j, int k) {
    return std::ranges::any_of(neck.found, [&](const ProposedStructure& one) {
      return labelOf(one.structure) == label && one.voxels.isSelected(i, j, k);
    });
  };
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i)
        for (const auto& off : kNear) {
          const bool isPair = isIn(kVein, i, j, k) && isIn(kArtery, i + off[0], j + off[1], k + off[2]);
          const bool isOther = isIn(kArtery, i, j, k) && isIn(kVein, i + off[0], j + off[1], k + off[2]);
          touching += isPair || isOther ? 1 : 0;
        }
  EXPECT_EQ(touching, 0U);
}

TEST(NeckAtlas, RefusesLabelsOfAnotherGridAndStopsWhenCancelled) {
  const ProposedNeck& neck = proposedNeck();
  const auto other = proposeNeck(neck.truth.ct, LabelMap(), neck.atlas);
  ASSERT_FALSE(other);
  EXPECT_THAT(other.error().message, HasSubstr("not on the grid of the CT"));
  const auto none = proposeNeck(neck.truth.ct, neck.automatic, {});
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, HasSubstr("No neck was found in this CT"));
  const auto cancelled =
      proposeNeck(neck.truth.ct, neck.automatic, neck.atlas, [](std::string_view, double) { return false; });
  ASSERT_FALSE(cancelled);
  EXPECT_EQ(cancelled.error().message, kCancelled);
}

TEST(NeckAtlas, MirroredNecksHaveTheirVesselsOnTheOtherSide) {
  for (const AtlasNeck& neck : proposedNeck().atlas)
    for (std::size_t n = 0; n < kNeckVessels; ++n) {
      const bool isRight = nameOf(static_cast<NeckStructure>(n)).starts_with("right");
      for (const AtlasNeck::VesselPoint& point : neck.vessels[n])
        EXPECT_TRUE(isRight ? point.position_mm.x < 0 : point.position_mm.x > 0);
      EXPECT_LT(neck.vessels[n].front().position_mm.z, neck.vessels[n].back().position_mm.z);
    }
}

}  // namespace
}  // namespace insonate
