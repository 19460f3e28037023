#include "PrepareWindow.h"

#include <insonate/ui/MainWindow.h>

#include <random>

namespace insonate::prepare {
namespace {

LabelStep brush(std::uint8_t label, double radius_mm = 2) {
  LabelStep step;
  step.tool = step::Paint{.radius_mm = radius_mm};
  step.label = label;
  return step;
}

LabelStep thresholdOf(std::uint8_t label, int low_HU, int high_HU) {
  LabelStep step;
  step.tool = step::Threshold{{low_HU, high_HU}};
  step.label = label;
  return step;
}

class Labeling : public PrepareWindow {
 protected:
  void SetUp() override {
    PrepareWindow::SetUp();
    openCase();
    labels_ = &shared_->labeling;
    QObject::connect(labels_, &LabelSession::failed, labels_, [this](const QString& text) { said_ = text; });
  }
  bool stroke(std::uint8_t label, std::vector<Vec3> points_mm) {
    if (!labels_->beginStroke(brush(label), "paint")) return false;
    for (const Vec3& point : points_mm) labels_->strokeTo(point);
    labels_->endStroke();
    return true;
  }
  std::vector<std::uint8_t> voxels() const { return labels_->labels().voxels; }
  bool atRest() {
    return QTest::qWaitFor([&] { return !labels_->isBusy(); }, kPatience_ms);
  }
  Result<LabelChange> runToEnd(const LabelStep& step, const QString& name = "tool") {
    std::optional<Result<LabelChange>> result;
    labels_->run(step, name, [&](const Result<LabelChange>& change) { result = change; });
    EXPECT_TRUE(QTest::qWaitFor([&] { return result.has_value(); }, kPatience_ms));
    return result ? *result : Result<LabelChange>(fail("nothing came"));
  }

  LabelSession* labels_ = nullptr;
  QString said_;
};

TEST_F(Labeling, AStrokeChangesExactlyTheVoxelsAroundItsLine) {
  const Vec3 a{-10, 10, 0}, b{-4, 14, 0};
  LabelMap expected = patient()->labels;
  const VolumeGeometry& grid = expected.geometry;
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) {
        const Vec3 at = grid.patientFromIndex() * Vec3{double(i), double(j), double(k)};
        const double along = std::clamp(dot(at - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
        if (norm(at - (a + (b - a) * along)) <= 2) expected.at(i, j, k) = kArtery;
      }
  ASSERT_TRUE(stroke(kArtery, {a, b}));
  EXPECT_EQ(voxels(), expected.voxels);
  EXPECT_EQ(shared_->openCase.undoStack().count(), 1) << "one stroke, one step";
  EXPECT_TRUE(labels_->isChanged());
  EXPECT_NE(std::ranges::find(shared_->structures.labels(), std::uint8_t{kArtery}), shared_->structures.labels().end());
  EXPECT_EQ(patient()->labels.voxels, test::smallCase().labels.voxels) << "the case itself never changes";
}

TEST_F(Labeling, UndoTakesStrokesToolsAndColorsInTheOrderInWhichTheyCame) {
  const auto before = voxels();
  stroke(kArtery, {{-10, 10, 0}});
  const auto painted = voxels();
  shared_->appearance.setColor(kArtery, {1, 2, 3});
  ASSERT_TRUE(runToEnd(thresholdOf(kCartilage, 800, 1000)));
  const auto thresholded = voxels();
  EXPECT_NE(thresholded, painted);
  child<QAction>("undo")->trigger();
  EXPECT_EQ(voxels(), painted);
  EXPECT_EQ(shared_->appearance.look(kArtery).color, (views::Color{1, 2, 3}));
  child<QAction>("undo")->trigger();
  EXPECT_NE(shared_->appearance.look(kArtery).color, (views::Color{1, 2, 3}));
  EXPECT_EQ(voxels(), painted);
  child<QAction>("undo")->trigger();
  EXPECT_EQ(voxels(), before);
  EXPECT_FALSE(labels_->isChanged());
  for (int n = 0; n < 3; ++n) child<QAction>("redo")->trigger();
  EXPECT_EQ(voxels(), thresholded);
}

TEST_F(Labeling, WhatAStepOfTheGuideHasComeToIsTakenBackAsOne) {
  const auto before = voxels();
  const auto of = [](LabelStep step, const char* name) {
    step.of = name;
    return step;
  };
  LabelStep wider;
  wider.tool = step::Margin{1};
  wider.label = kThyroid;
  ASSERT_TRUE(runToEnd(of(thresholdOf(kThyroid, 44, 46), "thyroid")));
  ASSERT_TRUE(runToEnd(of(wider, "thyroid")));
  const auto thyroid = voxels();
  ASSERT_TRUE(runToEnd(of(thresholdOf(kCartilage, 800, 1000), "cartilage")));
  ASSERT_EQ(labels_->recipe().steps.size(), 3u);
  child<QAction>("undo")->trigger();
  EXPECT_EQ(voxels(), thyroid) << "another step of the guide is one of its own";
  child<QAction>("undo")->trigger();
  EXPECT_EQ(voxels(), before);
  EXPECT_TRUE(labels_->recipe().steps.empty());
  child<QAction>("redo")->trigger();
  EXPECT_EQ(voxels(), thyroid);
  EXPECT_EQ(labels_->recipe().steps.size(), 2u);
}

TEST_F(Labeling, SixtyStepsGoBackAndForth) {
  std::vector<std::vector<std::uint8_t>> states{voxels()};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(-20, 20), y(2, 24), z(-7, 7);
  for (int n = 0; n < 60; ++n) {
    stroke(n % 2 ? kArtery : kThyroid, {{x(random), y(random), z(random)}, {x(random), y(random), z(random)}});
    if (n % 7 == 0) shared_->appearance.setVisible(kBone, !shared_->appearance.look(kBone).visible);
    states.push_back(voxels());
  }
  const auto seen = [&] { return std::ranges::find(states, voxels()) != states.end(); };
  while (shared_->openCase.undoStack().canUndo()) {
    shared_->openCase.undoStack().undo();
    ASSERT_TRUE(seen());
  }
  EXPECT_EQ(voxels(), states.front());
  EXPECT_TRUE(labels_->recipe().steps.empty());
  while (shared_->openCase.undoStack().canRedo()) shared_->openCase.undoStack().redo();
  EXPECT_EQ(voxels(), states.back());
  EXPECT_EQ(labels_->recipe().steps.size(), 60u);
}

TEST_F(Labeling, MoreStepsThanAreRememberedUndoAsFarAsTheyGo) {
  for (int n = 0; n < 130; ++n) stroke(n % 2 ? kArtery : kThyroid, {{0, 12, 0}});
  int undone = 0;
  while (shared_->openCase.undoStack().canUndo()) shared_->openCase.undoStack().undo(), ++undone;
  EXPECT_EQ(undone, OpenCase::kMaxUndo);
  while (shared_->openCase.undoStack().canRedo()) shared_->openCase.undoStack().redo();
  EXPECT_EQ(labels_->labels().at(24, 18, 8), kArtery);
}

TEST_F(Labeling, LockedAndHiddenLabelsStay) {
  LabelRules rules = labels_->rules();
  rules.locked.set(kVein);
  labels_->setRules(rules);
  shared_->appearance.setVisible(kBone, false);
  stroke(kArtery, {{0, 12, 0}, {0, 30, 0}});
  const auto& now = labels_->labels();
  for (std::size_t v = 0; v < now.voxels.size(); ++v) {
    const std::uint8_t was = patient()->labels.voxels[v];
    if (was == kVein || was == kBone) {
      ASSERT_EQ(now.voxels[v], was);
    }
  }
  EXPECT_FALSE(stroke(kVein, {{-10, 10, 0}}));
  EXPECT_EQ(said_, "The label vein is locked; unlock it to edit it.");
  EXPECT_FALSE(runToEnd(thresholdOf(kBone, 0, 100)));
  EXPECT_EQ(said_, "The label bone is hidden; show it to edit it.");
  EXPECT_TRUE(workspace_->statusText().contains("hidden"));
}

TEST_F(Labeling, ACancelledToolLeavesTheLabelsAsTheyWere) {
  const auto before = voxels();
  std::optional<Result<LabelChange>> result;
  labels_->run(thresholdOf(kArtery, 0, 2000), "threshold", [&](const auto& change) { result = change; });
  EXPECT_TRUE(labels_->isBusy());
  EXPECT_FALSE(stroke(kArtery, {{0, 12, 0}})) << "one at a time";
  tasks_.cancel();
  ASSERT_TRUE(result);
  EXPECT_EQ(result->error().message, kCancelled);
  QTest::qWait(200);
  EXPECT_EQ(voxels(), before);
  EXPECT_FALSE(shared_->openCase.undoStack().canUndo());
  EXPECT_TRUE(stroke(kArtery, {{0, 12, 0}}));
}

TEST_F(Labeling, UndoWhileAToolRunsEndsItFirst) {
  const auto before = voxels();
  for (const int wait_ms : {0, 1, 2, 5, 20}) {
    stroke(kArtery, {{0, 12, 0}});
    labels_->run(thresholdOf(kThyroid, 0, 2000), "threshold");
    QTest::qWait(wait_ms);
    while (shared_->openCase.undoStack().canUndo()) shared_->openCase.undoStack().undo();
    EXPECT_FALSE(labels_->isBusy());
    EXPECT_EQ(voxels(), before);
    QTest::qWait(30);
    EXPECT_EQ(voxels(), before) << "nothing comes later";
  }
}

TEST_F(Labeling, AnotherCaseWhileAToolRunsIsNotTouched) {
  const auto other = std::make_shared<const PatientCase>(test::smallAttemptCase());
  for (const int wait_ms : {0, 1, 3, 10}) {
    labels_->run(thresholdOf(kThyroid, -2000, 2000), "threshold");
    QTest::qWait(wait_ms);
    workspace_->setCase(other);
    EXPECT_FALSE(labels_->isBusy());
    QTest::qWait(30);
    EXPECT_EQ(voxels(), other->labels.voxels);
    EXPECT_FALSE(labels_->isChanged());
    workspace_->setCase(patient());
  }
  labels_->run(thresholdOf(kThyroid, -2000, 2000), "threshold");
  workspace_->setCase(nullptr);
  QTest::qWait(30);
  EXPECT_FALSE(labels_->isBusy());
}

TEST_F(Labeling, TheLatestPreviewWinsAndChangesNothing) {
  const auto before = voxels();
  for (const int low : {-500, 0, 100, 500, 800}) labels_->wantPreview(thresholdOf(kArtery, low, 2000));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !labels_->preview().isComputing(); }, kPatience_ms));
  ASSERT_TRUE(labels_->preview().proposal());
  const auto& shown = labels_->preview().proposal()->labels.voxels;
  EXPECT_EQ(std::ranges::count(shown, kArtery), std::ranges::count(patient()->ct.voxels, 900));
  EXPECT_EQ(voxels(), before);
  labels_->wantPreview(thresholdOf(kArtery, 0, 2000));
  labels_->preview().clear();
  QTest::qWait(50);
  EXPECT_FALSE(labels_->preview().proposal());
}

TEST_F(Labeling, WhatWasDoneReplaysToTheSameVoxels) {
  stroke(kArtery, {{-10, 10, 0}, {-4, 14, 0}, {2, 20, 3}});
  ASSERT_TRUE(runToEnd(thresholdOf(kCartilage, 800, 1000)));
  stroke(kThyroid, {{10, 10, 0}});
  shared_->openCase.undoStack().undo();
  const auto recipe = readRecipe(textOf(labels_->recipe()));
  ASSERT_TRUE(recipe) << recipe.error().message;
  ASSERT_EQ(recipe->steps.size(), 2u);
  LabelMap again = patient()->labels;
  LabelEdit edit(patient()->ct, again);
  ASSERT_TRUE(perform(*recipe, edit));
  EXPECT_EQ(again.voxels, voxels());
}

TEST_F(Labeling, SurfacesTheLivePictureAndTheCheckFollow) {
  EXPECT_TRUE(scene().structures().size() > 0);
  const auto pictured = shared_->live.shown();
  stroke(kArtery, {{0, 8, -4}, {0, 8, 4}});
  EXPECT_FALSE(workspace_->isReady());
  ASSERT_TRUE(QTest::qWaitFor([&] { return workspace_->isReady(); }, kPatience_ms));
  const auto& all = scene().structures();
  EXPECT_NE(std::ranges::find(all, std::uint8_t{kArtery}), all.end()) << "it has a surface";
  EXPECT_NE(shared_->live.shown(), pictured);
  EXPECT_EQ(shared_->measuring.measures()->statistics.voxels[kArtery],
            std::size_t(std::ranges::count(labels_->labels().voxels, kArtery)));
  shared_->openCase.undoStack().undo();
  ASSERT_TRUE(QTest::qWaitFor([&] { return workspace_->isReady(); }, kPatience_ms));
  const auto& left = scene().structures();
  EXPECT_EQ(std::ranges::find(left, std::uint8_t{kArtery}), left.end()) << "what is gone has none";
}

}  // namespace
}  // namespace insonate::prepare
