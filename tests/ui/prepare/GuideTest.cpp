#include "PrepareWindow.h"
#include "guide/GuideSession.h"

#include <gmock/gmock.h>

#include <QListWidget>
#include <QTabBar>

namespace insonate::prepare {
namespace {

using State = GuideSession::State;
using testing::HasSubstr;

constexpr double kArtery_x = -14;

/// The small block with contrast agent in a vein and an artery that nobody has labelled.
std::shared_ptr<const PatientCase> unlabelled() {
  static const auto made = [] {
    auto patient = std::make_shared<PatientCase>(test::smallCase());
    const VolumeGeometry& grid = patient->ct.geometry;
    for (int k = 0; k < grid.size[2]; ++k)
      for (int j = 8; j < grid.size[1]; ++j)
        for (int i = 0; i < grid.size[0]; ++i) {
          const Vec3 p = grid.patientFromIndex() * Vec3{double(i), double(j), double(k)};
          const bool vein = std::hypot(p.x, p.y - 12) < 5, artery = std::hypot(p.x - kArtery_x, p.y - 12) < 2.2;
          if (patient->labels.at(i, j, k) != kBone) patient->labels.at(i, j, k) = kSoftTissue;
          patient->ct.at(i, j, k) = vein ? 180 : artery ? 260 : 45;
        }
    return patient;
  }();
  return made;
}

class Guiding : public PrepareWindow {
 protected:
  void SetUp() override {
    PrepareWindow::SetUp();
    openCase(unlabelled());
    child<QTabBar>("labelling")->setCurrentIndex(0);
    guide_ = workspace_->findChild<GuideSession*>();
    ASSERT_TRUE(guide_);
  }
  void choose(const char* name) {
    auto* list = child<QListWidget>("guideSteps");
    for (std::size_t n = 0; n < guide_->steps().size(); ++n)
      if (guide_->steps()[n].name == name)
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(int(n))).center());
    ASSERT_EQ(guide_->step().name, name);
  }
  QPoint placeOf(Vec3 patient_mm) {
    session_->setCrosshair(patient_mm);
    const views::DisplayPoint at = axial().displayFromPatient(patient_mm);
    const double ratio = canvas("Axial slice")->devicePixelRatioF();
    return {int(at.x / ratio), int(at.y / ratio)};
  }
  void click(Vec3 patient_mm, Qt::MouseButton button = Qt::LeftButton) {
    QTest::mouseClick(canvas("Axial slice"), button, {}, placeOf(patient_mm));
  }
  void drag(Vec3 from_mm, Vec3 to_mm, Qt::KeyboardModifiers keys = Qt::NoModifier) {
    QWidget* slice = canvas("Axial slice");
    const QPoint from = placeOf(from_mm), to = placeOf(to_mm);
    QTest::mousePress(slice, Qt::LeftButton, keys, from);
    QMouseEvent move(QEvent::MouseMove, to, Qt::NoButton, Qt::LeftButton, keys);
    QCoreApplication::sendEvent(slice, &move);
    QTest::mouseRelease(slice, Qt::LeftButton, keys, to);
  }
  void run() {
    child<QPushButton>("guideRun")->click();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !guide_->isBusy(); }, kPatience_ms));
  }
  void makeVein(double aside = 0) {
    choose("vein-right");
    click({aside, 12, -7});
    click({aside, 12, 7});
    run();
  }
  void makeArtery() {
    choose("artery-right");
    click({kArtery_x, 12, -7});
    click({kArtery_x, 12, 7});
    run();
  }
  std::size_t count(std::uint8_t label) {
    return std::size_t(std::ranges::count(session_->labelling().labels().voxels, label));
  }
  const std::vector<std::uint8_t>& voxels() { return session_->labelling().labels().voxels; }

  GuideSession* guide_ = nullptr;
};

TEST_F(Guiding, SaysWhatToDoBeforeAnythingIsClicked) {
  choose("vein-right");
  EXPECT_THAT(child<QLabel>("guideSay")->text().toStdString(), HasSubstr("Click in the middle"));
  EXPECT_FALSE(child<QPushButton>("guideRun")->isEnabled()) << "no clicks yet";
  EXPECT_FALSE(child<QPushButton>("guideAccept")->isVisible());
  EXPECT_EQ(guide_->state(guide_->current()), State::ToDo);
}

TEST_F(Guiding, TwoClicksInASliceMakeTheVein) {
  makeVein();
  EXPECT_EQ(guide_->state(guide_->current()), State::Done)
      << guide_->remarks(guide_->current()).join(' ').toStdString();
  // pi 5^2 over 14 mm
  EXPECT_NEAR(double(count(kVein)), 1100, 220);
  EXPECT_TRUE(child<QPushButton>("guideAccept")->isVisible());
  key(Qt::Key_Return);
  EXPECT_EQ(guide_->step().name, "artery-right") << "Enter goes on to what is to do";
}

TEST_F(Guiding, ClicksAreShownMovedAndRemoved) {
  choose("vein-right");
  click({0, 12, 0});
  click({4, 12, 0});
  ASSERT_EQ(guide_->clicks_mm().size(), 2u);
  EXPECT_TRUE(axial().showsMark(guide_->clicks_mm()[1]));
  drag({4, 12, 0}, {9, 20, 0});
  ASSERT_EQ(guide_->clicks_mm().size(), 2u);
  EXPECT_LT(norm(guide_->clicks_mm()[1] - Vec3{9, 20, 0}), 0.5);
  click({0, 12, 0}, Qt::RightButton);
  ASSERT_EQ(guide_->clicks_mm().size(), 1u);
  EXPECT_LT(norm(guide_->clicks_mm()[0] - Vec3{9, 20, 0}), 0.5) << "the other one is left";
  key(Qt::Key_Delete);
  EXPECT_TRUE(guide_->clicks_mm().empty());
}

TEST_F(Guiding, AClickIsNoneWhileTheTableIsShown) {
  choose("vein-right");
  child<QTabBar>("labelling")->setCurrentIndex(1);
  click({0, 12, 0});
  EXPECT_TRUE(guide_->clicks_mm().empty());
}

TEST_F(Guiding, WhatIsTooThinForAVeinIsDoubtful) {
  makeVein(kArtery_x);
  EXPECT_TRUE(QTest::qWaitFor([&] { return guide_->state(1) == State::Doubtful; }, kPatience_ms));
  EXPECT_THAT(child<QLabel>("guideResult")->text().toStdString(), HasSubstr("a mean diameter of"));
  child<QPushButton>("guideAccept")->click();
  EXPECT_EQ(guide_->state(1), State::Done) << "the author has looked";
}

TEST_F(Guiding, UndoMakesAStepToDoAgainAndRedoDone) {
  makeVein();
  child<QAction>("undo")->trigger();
  EXPECT_EQ(count(kVein), 0u);
  EXPECT_EQ(guide_->state(1), State::ToDo);
  EXPECT_EQ(guide_->clicks_mm().size(), 2u) << "what was clicked stays";
  child<QAction>("redo")->trigger();
  EXPECT_EQ(guide_->state(1), State::Done);
}

TEST_F(Guiding, AnEarlierStepIsDoneAgainWithoutLossOfLaterOnes) {
  makeVein(2.5);
  makeArtery();
  const std::size_t artery = count(kArtery);
  const std::vector<std::uint8_t> before = voxels();
  ASSERT_GT(artery, 100u);
  choose("vein-right");
  click({2.5, 12, -7}, Qt::RightButton);
  click({0, 12, -2});
  run();
  EXPECT_NE(voxels(), before) << "the vein begins elsewhere";
  EXPECT_EQ(count(kArtery), artery);
  EXPECT_EQ(session_->labelling().recipe().steps.size(), 2u) << "nothing is recorded twice";
  EXPECT_EQ(guide_->state(1), State::Done);
  EXPECT_NE(guide_->state(2), State::ToDo);
  child<QAction>("undo")->trigger();
  EXPECT_EQ(count(kArtery), 0u);
  EXPECT_EQ(guide_->state(2), State::ToDo);
}

TEST_F(Guiding, CorrectingPaintsAndErasesThisStructureAndSparesOthers) {
  makeVein();
  makeArtery();
  choose("vein-right");
  const std::size_t vein = count(kVein), artery = count(kArtery);
  child<QPushButton>("guideCorrect")->click();
  ASSERT_TRUE(guide_->isCorrecting());
  drag({-6, 12, 0}, {kArtery_x, 12, 0});
  EXPECT_GT(count(kVein), vein + 20);
  EXPECT_EQ(count(kArtery), artery) << "painted over, but locked";
  child<QAction>("undo")->trigger();
  EXPECT_EQ(count(kVein), vein);
  drag({0, 12, 0}, {3, 12, 0}, Qt::ControlModifier);
  EXPECT_LT(count(kVein), vein - 20);
}

TEST_F(Guiding, WhatIsSavedReplaysToTheSameVoxelsAndIsTakenUpAgain) {
  const test::TemporaryFolder folder;
  makeVein();
  makeArtery();
  child<QPushButton>("guideCorrect")->click();
  drag({kArtery_x, 12, 0}, {kArtery_x - 4, 12, 0});
  const std::vector<std::uint8_t> made = voxels();

  auto saved = std::make_shared<PatientCase>(*unlabelled());
  workspace_->unsavedEdit()(*saved);
  ASSERT_EQ(saved->labels.voxels, made);
  ASSERT_TRUE(writeCase(*saved, folder.path() / "case"));
  ui::CaseOrigin origin;
  origin.folder = QString::fromStdString((folder.path() / "case").string());
  workspace_->setOrigin(origin);
  workspace_->caseSaved(saved);

  const auto recipe = loadRecipe((folder.path() / "case" / "recipe.json").string());
  ASSERT_TRUE(recipe) << recipe.error().message;
  PatientCase imported = *unlabelled();
  LabelEdit edit(imported.ct, imported.labels);
  ASSERT_TRUE(perform(*recipe, edit));
  EXPECT_EQ(imported.labels.voxels, made);
  const auto back = readCase(folder.path() / "case");
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->patient.labels.voxels, made);

  // Another day.
  openCase(std::make_shared<const PatientCase>(back->patient));
  EXPECT_EQ(guide_->state(1), State::Done);
  choose("vein-right");
  ASSERT_EQ(guide_->clicks_mm().size(), 2u);
  EXPECT_LT(norm(guide_->clicks_mm()[0] - Vec3{0, 12, -7}), 0.5);
  EXPECT_EQ(guide_->state(0), State::ToDo);
}

TEST_F(Guiding, AStepThatFailsLeavesWhatWasThere) {
  makeVein();
  const std::vector<std::uint8_t> before = voxels();
  // Both clicks on one point.
  drag({0, 12, 7}, {0, 12, -7});
  choose("vein-right");
  guide_->moveClick(1, guide_->clicks_mm()[0]);
  run();
  EXPECT_THAT(child<QLabel>("guideTold")->text().toStdString(), HasSubstr("nearly on one point"));
  EXPECT_EQ(voxels(), before);
}

TEST_F(Guiding, AnotherCaseWhileAToolRunsBeginsAnew) {
  choose("vein-right");
  click({0, 12, -7});
  click({0, 12, 7});
  child<QPushButton>("guideRun")->click();
  openCase();
  EXPECT_FALSE(guide_->isBusy());
  EXPECT_EQ(guide_->state(1), State::ToDo);
  EXPECT_TRUE(guide_->clicks_mm().empty());
}

}  // namespace
}  // namespace insonate::prepare
