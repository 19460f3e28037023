#include <insonate/core/Hash.h>
#include <insonate/segmentation/LabelEdit.h>
#include <insonate/tissue/Labels.h>

#include <gmock/gmock.h>

namespace insonate {
namespace {

using testing::HasSubstr;

VolumeGeometry grid(int n) {
  VolumeGeometry g;
  g.size = {n, n + 3, n + 5};
  return g;
}

Proposal block(const VolumeGeometry& g, const VoxelBox& box, std::uint8_t label) {
  Selection all(g, box);
  std::ranges::fill(all.mask.voxels, std::uint8_t{1});
  return proposePainting(std::move(all), label);
}

/// Every fourth voxel or so gets one of a few labels, nothing runs on for long.
Proposal noise(const VolumeGeometry& g, const VoxelBox& box, std::uint32_t seed) {
  Proposal p{box, Volume<std::uint8_t>(gridOf(g, box))};
  for (std::size_t v = 0; v < p.labels.voxels.size(); ++v) {
    const std::uint32_t h = hashNode(static_cast<int>(v), 0, 0, seed);
    p.labels.voxels[v] = h % 4 ? Proposal::kKeep : static_cast<std::uint8_t>(h / 4 % 5);
  }
  return p;
}

struct Desk {
  explicit Desk(int n = 20, std::size_t maxUndoBytes = LabelEdit::kMaxUndoBytes)
      : ct(grid(n)), labels(grid(n), kSoftTissue), edit(ct, labels, maxUndoBytes) {}
  CtVolume ct;
  LabelMap labels;
  LabelEdit edit;
};

TEST(LabelEdit, SaysWhichBoxAndWhichLabelsHaveChanged) {
  Desk d;
  d.labels.at(4, 5, 6) = kBone;
  const auto change = d.edit.apply(block(d.labels.geometry, {{4, 5, 6}, {7, 6, 8}}, kBone), "paint");
  ASSERT_TRUE(change);
  EXPECT_EQ(change->voxels, 5u) << "six chosen, one was bone already";
  EXPECT_EQ(change->box, (VoxelBox{{4, 5, 6}, {7, 6, 8}}));
  EXPECT_EQ(change->labels, LabelSet().set(kBone).set(kSoftTissue));
  EXPECT_EQ(d.labels.at(6, 5, 7), kBone);
  EXPECT_EQ(d.labels.at(7, 5, 7), kSoftTissue);
}

TEST(LabelEdit, SixtyStepsAreUndoneAndRedoneToTheVoxel) {
  Desk d;
  std::vector<std::vector<std::uint8_t>> states{d.labels.voxels};
  for (std::uint32_t n = 0; n < 60; ++n) {
    const int first = static_cast<int>(n % 9);
    const VoxelBox box{{first, 2, first}, {20, 19, 25 - first}};
    ASSERT_TRUE(d.edit.apply(noise(d.labels.geometry, box, n), "step " + std::to_string(n)));
    states.push_back(d.labels.voxels);
  }
  for (std::size_t n = 60; n-- > 0;) {
    EXPECT_EQ(d.edit.undoName(), "step " + std::to_string(n));
    EXPECT_GT(d.edit.undo().voxels, 0u);
    ASSERT_EQ(d.labels.voxels, states[n]) << n;
  }
  EXPECT_FALSE(d.edit.undoName());
  EXPECT_EQ(d.edit.undo().voxels, 0u) << "nothing left";
  for (std::size_t n = 1; n <= 60; ++n) {
    d.edit.redo();
    ASSERT_EQ(d.labels.voxels, states[n]) << n;
  }
  EXPECT_FALSE(d.edit.redoName());
}

TEST(LabelEdit, UndoSaysTheSameBoxAsTheEdit) {
  Desk d;
  const auto change = d.edit.apply(block(d.labels.geometry, {{1, 2, 3}, {4, 5, 6}}, kVein), "paint");
  const LabelChange back = d.edit.undo();
  EXPECT_EQ(back.box, change->box);
  EXPECT_EQ(back.labels, change->labels);
  EXPECT_EQ(back.voxels, change->voxels);
}

TEST(LabelEdit, AnEditAfterUndoTakesTheRedoAway) {
  Desk d;
  ASSERT_TRUE(d.edit.apply(block(d.labels.geometry, {{0, 0, 0}, {5, 5, 5}}, kVein), "one"));
  d.edit.undo();
  EXPECT_EQ(d.edit.redoName(), "one");
  ASSERT_TRUE(d.edit.apply(block(d.labels.geometry, {{0, 0, 0}, {2, 2, 2}}, kBone), "two"));
  EXPECT_FALSE(d.edit.redoName());
  EXPECT_EQ(d.edit.redo().voxels, 0u);
}

TEST(LabelEdit, AStepThatChangesNothingIsNone) {
  Desk d;
  const auto change = d.edit.apply(block(d.labels.geometry, {{0, 0, 0}, {5, 5, 5}}, kSoftTissue), "nothing");
  ASSERT_TRUE(change);
  EXPECT_TRUE(change->box.empty());
  EXPECT_EQ(d.edit.undoSteps(), 0u);
  EXPECT_EQ(d.edit.revision(), 0u);
}

TEST(LabelEdit, AStrokeIsOneStep) {
  Desk d;
  const auto before = d.labels.voxels;
  d.edit.beginStroke("paint");
  for (int n = 0; n < 10; ++n)
    ASSERT_TRUE(d.edit.apply(block(d.labels.geometry, {{n, 3, 3}, {n + 3, 6, 6}}, kVein), "dab"));
  d.edit.endStroke();
  ASSERT_TRUE(d.edit.apply(block(d.labels.geometry, {{0, 0, 0}, {9, 9, 9}}, kBone), "block"));
  EXPECT_EQ(d.edit.undoSteps(), 2u);
  d.edit.undo();
  EXPECT_EQ(d.edit.undoName(), "paint");
  EXPECT_EQ(d.edit.undo().box, (VoxelBox{{0, 3, 3}, {12, 6, 6}}));
  EXPECT_EQ(d.labels.voxels, before);
}

TEST(LabelEdit, OverlappingDabsOfAStrokeCostOnlyWhatEachChanges) {
  Desk d(40);
  d.edit.beginStroke("paint");
  ASSERT_TRUE(d.edit.apply(block(d.labels.geometry, {{0, 0, 0}, {30, 30, 30}}, kVein), "dab"));
  const std::size_t once = d.edit.bytes();
  ASSERT_TRUE(d.edit.apply(block(d.labels.geometry, {{0, 0, 0}, {30, 30, 30}}, kVein), "dab"));
  EXPECT_EQ(d.edit.bytes(), once);
}

TEST(LabelEdit, AStepCostsFarLessThanACopy) {
  Desk d(100);
  for (int n = 0; n < 50; ++n)
    ASSERT_TRUE(
        d.edit.apply(block(d.labels.geometry, {{n, n, n}, {n + 20, n + 20, n + 20}}, n % 2 ? kVein : kBone), "block"));
  EXPECT_EQ(d.edit.undoSteps(), 50u);
  EXPECT_LT(d.edit.bytes(), d.labels.voxels.size()) << "50 steps in less than one copy";
}

TEST(LabelEdit, MemoryIsBoundedAndTheLatestStepCanBeUndone) {
  constexpr std::size_t kMost = 40000;
  Desk d(40, kMost);
  std::vector<std::uint8_t> before;
  for (std::uint32_t n = 0; n < 20; ++n) {
    before = d.labels.voxels;
    ASSERT_TRUE(d.edit.apply(noise(d.labels.geometry, {{0, 0, 0}, {40, 40, 4}}, n), "noise"));
    EXPECT_LE(d.edit.bytes(), kMost);
  }
  EXPECT_GE(d.edit.undoSteps(), 1u);
  EXPECT_LT(d.edit.undoSteps(), 20u);
  ASSERT_TRUE(d.edit.apply(noise(d.labels.geometry, boxOf(d.labels.geometry), 99), "larger than what is allowed"));
  EXPECT_EQ(d.edit.undoSteps(), 1u);
  before = d.labels.voxels;
  d.edit.undo();
  d.edit.redo();
  EXPECT_EQ(d.labels.voxels, before);
}

TEST(LabelEdit, LockedAndHiddenLabelsNeitherLoseNorGain) {
  for (const bool hidden : {false, true}) {
    Desk d;
    d.labels.at(3, 3, 3) = kArtery;
    (hidden ? d.edit.rules.hidden : d.edit.rules.locked).set(kArtery);
    ASSERT_TRUE(d.edit.apply(block(d.labels.geometry, {{2, 2, 2}, {5, 5, 5}}, kVein), "paint"));
    EXPECT_EQ(d.labels.at(3, 3, 3), kArtery);
    EXPECT_EQ(d.labels.at(2, 3, 3), kVein);

    const auto refused = d.edit.apply(block(d.labels.geometry, {{2, 2, 2}, {5, 5, 5}}, kArtery), "paint");
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().message, HasSubstr("The label artery is"));
    EXPECT_THAT(refused.error().message, HasSubstr(hidden ? "show it" : "unlock it"));
    EXPECT_EQ(d.labels.at(2, 3, 3), kVein);
  }
}

TEST(LabelEdit, UndoRestoresALabelThatHasBeenLockedSince) {
  Desk d;
  ASSERT_TRUE(d.edit.apply(block(d.labels.geometry, {{2, 2, 2}, {5, 5, 5}}, kVein), "paint"));
  d.edit.rules.locked.set(kVein);
  d.edit.undo();
  EXPECT_EQ(d.labels.at(3, 3, 3), kSoftTissue) << "undo takes back the step as it was";
}

TEST(LabelEdit, VoxelsOutsideTheEditableRangeStay) {
  Desk d;
  d.ct.at(3, 3, 3) = 300;
  d.ct.at(3, 3, 4) = 101;
  d.edit.rules.editable = HuRange{0, 100};
  ASSERT_TRUE(d.edit.apply(block(d.labels.geometry, {{3, 3, 2}, {4, 4, 6}}, kVein), "paint"));
  EXPECT_EQ(d.labels.at(3, 3, 2), kVein);
  EXPECT_EQ(d.labels.at(3, 3, 3), kSoftTissue);
  EXPECT_EQ(d.labels.at(3, 3, 4), kSoftTissue);
  EXPECT_EQ(d.labels.at(3, 3, 5), kVein);
}

TEST(LabelEdit, ABoxBeyondTheMapIsRefused) {
  Desk d;
  VolumeGeometry larger = grid(40);
  const auto refused = d.edit.apply(block(larger, {{0, 0, 0}, {40, 5, 5}}, kVein), "paint");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("lies outside the label map"));
  EXPECT_TRUE(d.edit.apply(Proposal{}, "nothing")) << "an empty region is no mistake";
}

TEST(Region, ReshapedLabelGivesBackWhatItLoses) {
  Desk d;
  d.labels.at(1, 1, 1) = kVein;
  d.labels.at(2, 1, 1) = kVein;
  d.labels.at(5, 5, 5) = kVein;
  Selection shape(d.labels.geometry, {{0, 0, 0}, {4, 4, 4}});
  shape.mask.at(2, 1, 1) = shape.mask.at(3, 1, 1) = 1;
  ASSERT_TRUE(d.edit.apply(proposeShape(shape, d.labels, kVein, kFat), "median"));
  EXPECT_EQ(d.labels.at(1, 1, 1), kFat);
  EXPECT_EQ(d.labels.at(2, 1, 1), kVein);
  EXPECT_EQ(d.labels.at(3, 1, 1), kVein);
  EXPECT_EQ(d.labels.at(5, 5, 5), kVein) << "beyond the block";
  EXPECT_EQ(d.labels.at(0, 0, 0), kSoftTissue);
}

TEST(Region, ExtentIsTheSmallestBox) {
  Desk d;
  EXPECT_TRUE(boundingBoxOf(d.labels, kVein).empty());
  d.labels.at(7, 3, 9) = d.labels.at(2, 5, 11) = d.labels.at(4, 4, 10) = kVein;
  EXPECT_EQ(boundingBoxOf(d.labels, kVein), (VoxelBox{{2, 3, 9}, {8, 6, 12}}));
  EXPECT_EQ(boundingBoxOf(d.labels, kSoftTissue), boxOf(d.labels.geometry));
}

TEST(LabelEdit, WhatIsLeftOfAProposalIsWhatWouldBeWritten) {
  Desk desk;
  desk.edit.apply(noise(grid(20), boxOf(grid(20)), 5), "before");
  for (std::size_t v = 0; v < desk.ct.voxels.size(); ++v) desk.ct.voxels[v] = std::int16_t(v % 97);
  EditRules rules;
  rules.locked.set(1), rules.hidden.set(2);
  rules.editable = HuRange{10, 60};
  rules.over.reset(3);
  const VoxelBox part{{2, 3, 4}, {17, 19, 21}};
  Proposal left = noise(grid(20), part, 6);
  removeForbiddenChanges(rules, desk.ct, desk.labels, left);
  LabelMap painted = desk.labels;
  for (int k = part.first[2]; k < part.end[2]; ++k)
    for (int j = part.first[1]; j < part.end[1]; ++j)
      for (int i = part.first[0]; i < part.end[0]; ++i) {
        const std::uint8_t label = left.labels.at(i - part.first[0], j - part.first[1], k - part.first[2]);
        if (label != Proposal::kKeep) painted.at(i, j, k) = label;
      }
  desk.edit.rules = rules;
  ASSERT_TRUE(desk.edit.apply(noise(grid(20), part, 6), "all"));
  EXPECT_EQ(desk.labels.voxels, painted.voxels);
}

}  // namespace
}  // namespace insonate
