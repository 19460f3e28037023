#include "GuideWindow.h"

#include <insonate/ui/ViewWidget.h>
#include <insonate/views/UltrasoundView.h>

#include <QRegularExpression>
#include <QThreadPool>

namespace insonate::prepare {
namespace {

TEST_F(Guiding, SaysWhatToDoBeforeAnythingIsClicked) {
  choose("vein-right");
  EXPECT_THAT(child<QLabel>("guideSay")->text().toStdString(), HasSubstr("Click in the middle"));
  EXPECT_FALSE(child<QPushButton>("guideRun")->isEnabled()) << "no clicks yet";
  EXPECT_FALSE(child<QPushButton>("guideAccept")->isVisible());
  EXPECT_EQ(guide_->state(guide_->current()), State::ToDo);
}

TEST_F(Guiding, WhatIsEnoughIsSaidWithEveryClick) {
  choose("vein-right");
  const auto said = [this] { return child<QLabel>("guideClicks")->text().toStdString(); };
  EXPECT_THAT(said(), HasSubstr("2 clicks are enough if the CT shows contrast agent, otherwise 4"));
  click({0, 12, -7});
  EXPECT_THAT(said(), HasSubstr("Clicks so far: 1; 1 more needed"));
  EXPECT_FALSE(child<QPushButton>("guideRun")->isEnabled());
  click({0, 12, 7});
  EXPECT_THAT(said(), HasSubstr("Clicks so far: 2, which is enough. If the structure is hard to see, make 4 clicks"));
  EXPECT_TRUE(child<QPushButton>("guideRun")->isEnabled());
  click({0, 12, 0});
  click({6, 12, 0});
  EXPECT_THAT(said(), HasSubstr("Clicks so far: 4, which is enough."));
}

TEST_F(Guiding, ADoubleClickEnlargesTheViewAndLeavesNoPoint) {
  choose("vein-right");
  click({0, 12, -7});
  auto* axialView = child<ui::ViewWidget>("Axial slice");
  const QPoint at = placeOf({9, 20, 0});
  const auto doubleClick = [&] {
    QTest::mouseClick(canvas("Axial slice"), Qt::LeftButton, {}, at);
    QTest::mouseDClick(canvas("Axial slice"), Qt::LeftButton, {}, at);
  };
  doubleClick();
  EXPECT_TRUE(axialView->isMaximized());
  EXPECT_EQ(guide_->clicks_mm().size(), 1u) << "what was clicked before stays";
  doubleClick();
  EXPECT_FALSE(axialView->isMaximized());
  ASSERT_EQ(guide_->clicks_mm().size(), 1u);
  EXPECT_LT(norm(guide_->clicks_mm()[0] - Vec3{0, 12, -7}), 0.5);
}

TEST_F(Guiding, AClickIsSeenUnderTheCrosshairAndIn3D) {
  choose("vein-right");
  const auto isWhite = [](const QColor& c) { return std::min({c.red(), c.green(), c.blue()}) > 95; };
  const auto near = [&](const char* view, QPoint at) {
    const QImage picture = canvas(view)->grab().toImage();
    for (int y = -2; y <= 2; ++y)
      for (int x = -2; x <= 2; ++x)
        if (picture.rect().contains(at + QPoint(x, y)) && isWhite(picture.pixelColor(at + QPoint(x, y)))) return true;
    return false;
  };
  // In the air, where nothing else is; the probe stands beside the crosshair.
  const Vec3 at_mm{20, -8, 0}, above_mm{0, 12, 25};
  const QPoint ring = placeOf(at_mm) + QPoint(5, 0);
  const auto inScene = [&] {
    const views::DisplayPoint at = scene().displayFromPatient(above_mm);
    return QPoint(int(at.x), int(at.y)) / canvas("Scene")->devicePixelRatioF();
  };
  EXPECT_FALSE(near("Axial slice", ring));
  EXPECT_FALSE(near("Scene", inScene()));
  click(at_mm);
  EXPECT_TRUE(QTest::qWaitFor([&] { return near("Axial slice", ring); }, kPatience_ms));
  guide_->addClick(above_mm);
  EXPECT_TRUE(QTest::qWaitFor([&] { return near("Scene", inScene()); }, kPatience_ms));
  key(Qt::Key_Delete);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !near("Scene", inScene()); }, kPatience_ms));
}

TEST_F(Guiding, WithoutContrastAgentItsResultIsToBeLookedThrough) {
  auto pale = std::make_shared<PatientCase>(*unlabeled());
  for (std::int16_t& voxel : pale->ct.voxels)
    if (voxel == 180 || voxel == 260) voxel = 75;
  openCase(pale);
  choose("vein-right");
  click({0, 12, -7});
  click({0, 12, -2.4});
  EXPECT_THAT(child<QLabel>("guideClicks")->text().toStdString(), HasSubstr("2 more needed. The CT shows no contrast"));
  EXPECT_FALSE(child<QPushButton>("guideRun")->isEnabled()) << "as the help says";
  click({0, 12, 2.4});
  click({0, 12, 7});
  run();
  EXPECT_THAT(child<QLabel>("guideResult")->text().toStdString(), HasSubstr("no contrast agent"));
  openCase(unlabeled());
  makeVein();
  EXPECT_THAT(child<QLabel>("guideResult")->text().toStdString(), testing::Not(HasSubstr("contrast")));
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

TEST_F(Guiding, ThePlacesComeBeforeTheOptionalStructures) {
  const auto& steps = guide_->steps();
  const auto places = std::ranges::find(steps, "places", &GuideStep::name);
  ASSERT_NE(places, steps.end());
  EXPECT_TRUE(std::none_of(steps.begin(), places, [](const GuideStep& step) { return step.optional; }));
  EXPECT_TRUE(std::all_of(places + 1, steps.end(), [](const GuideStep& step) { return step.optional; }));
}

TEST_F(Guiding, TheGuideAndTheListOfStructuresShowOneState) {
  makeVein();
  const auto shown = [this] { return child<QTreeWidget>("guideSteps")->topLevelItem(1)->text(1); };
  const auto listed = [this] { return stateWord(shared_->terms.stateOf(kVein)); };
  ASSERT_TRUE(QTest::qWaitFor([&] { return shared_->measuring.hasVoxels(kVein) && guide_->state(1) == State::Done; },
                              kPatience_ms));
  EXPECT_EQ(listed(), "in progress");
  EXPECT_EQ(shown(), listed());
  child<QPushButton>("guideAccept")->click();
  EXPECT_EQ(listed(), "completed");
  EXPECT_EQ(shown(), listed());
  shared_->terms.setState(kVein, LabelState::Flagged);
  EXPECT_EQ(shown(), "flagged");
}

TEST_F(Guiding, AcceptSaysWhenNothingIsLeftToDo) {
  const int last = int(guide_->steps().size()) - 1;
  for (int n = 0; n <= last; ++n)
    if (guide_->steps()[std::size_t(n)].name != "vein-right") {
      guide_->go(n);
      guide_->skip();
    }
  makeVein();
  child<QPushButton>("guideAccept")->click();
  EXPECT_TRUE(child<QLabel>("guideTold")->isVisible());
  EXPECT_THAT(child<QLabel>("guideTold")->text().toStdString(), HasSubstr("All steps are done"));
}

/// The step that replaces all labels must not run before the labels of the import are known.
TEST_F(Guiding, TheAutomaticStepWaitsUntilTheCaseIsMeasured) {
  shared_->measuring.setAllowed(false);
  workspace_->setCase(std::make_shared<const PatientCase>(*unlabeled()));
  child<QTabBar>("labelling")->setCurrentIndex(0);
  guide_->go(0);
  ASSERT_EQ(guide_->step().name, "automatic");
  ASSERT_FALSE(shared_->measuring.measures());
  EXPECT_FALSE(guide_->canRun());
  EXPECT_FALSE(child<QPushButton>("guideRun")->isEnabled());
  shared_->measuring.setAllowed(true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return shared_->measuring.measures() != nullptr; }, kPatience_ms));
  EXPECT_TRUE(guide_->canRun());
}

TEST_F(Guiding, TheKeyboardStaysWithTheGuideWhenItsButtonGoes) {
  makeVein();
  auto* accept = child<QPushButton>("guideAccept");
  accept->setFocus();
  accept->click();
  ASSERT_FALSE(accept->isVisible());
  auto* list = child<QTreeWidget>("guideSteps");
  EXPECT_EQ(workspace_->focusWidget(), list);
  const int step = guide_->current();
  QTest::keyClick(list, Qt::Key_G);
  QTest::keyClick(list, Qt::Key_C);
  EXPECT_FALSE(shared_->slices.labelsShown()) << "letters are keys of the room";
  EXPECT_EQ(guide_->current(), step) << "and look for no step";
}

TEST_F(Guiding, LabelsThatWereHiddenToFindTheVeinComeBackWithIt) {
  choose("vein-right");
  key(Qt::Key_G);
  ASSERT_FALSE(shared_->slices.labelsShown());
  makeVein();
  shared_->crosshair.moveTo({0, 12, 0});
  EXPECT_TRUE(shared_->slices.labelsShown());
  EXPECT_TRUE(workspace_->statusText().endsWith("vein")) << workspace_->statusText().toStdString();
}

/// An import of which nothing is labeled yet.
TEST_F(Guiding, ABareImportIsToldOfNoLabelsAndItsUltrasoundComesWithTheSkin) {
  auto bare = std::make_shared<PatientCase>(*unlabeled());
  std::ranges::fill(bare->labels.voxels, kBackground);
  bare->manifest.targets.clear(), bare->manifest.startPoses.clear();
  openCase(bare);
  ASSERT_EQ(guide_->current(), 0);
  EXPECT_TRUE(guide_->remarks(0).isEmpty()) << guide_->remarks(0).join(' ').toStdString();
  EXPECT_TRUE(child<QLabel>("sceneEmpty")->isVisible()) << "3D says what to do";
  EXPECT_THAT(child<QLabel>("sceneEmpty")->text().toStdString(), HasSubstr("first step of the guide"));
  EXPECT_THAT(child<QLabel>("ultrasoundState")->text().toStdString(), HasSubstr("no skin"));
  shared_->crosshair.moveTo({9, 12, 3});
  run();
  const auto stands = [&] { return shared_->live.standing() && shared_->live.shown(); };
  EXPECT_FALSE(child<QLabel>("sceneEmpty")->isVisible());
  ASSERT_TRUE(QTest::qWaitFor([&] { return stands() && shared_->live.state().isEmpty(); }, kPatience_ms))
      << shared_->live.state().toStdString();
  EXPECT_LT(norm(shared_->live.standing()->offset - Vec3{9, 0, 3}), 2) << "on the skin nearest to the crosshair";
  EXPECT_EQ(shared_->crosshair.position_mm(), (Vec3{9, 12, 3})) << "nobody is taken away from where he looks";
  shared_->crosshair.moveTo({-9, 12, -3});
  EXPECT_LT(norm(shared_->live.standing()->offset - Vec3{-9, 0, -3}), 2) << "and it follows";
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
  EXPECT_TRUE(QTest::qWaitFor([&] { return guide_->state(1) == State::Warning; }, kPatience_ms));
  EXPECT_THAT(child<QLabel>("guideResult")->text().toStdString(), HasSubstr("a mean diameter of"));
  EXPECT_TRUE(child<QLabel>("guideResult")->text().startsWith("Warning: ")) << "not by its color alone";
  child<QPushButton>("guideAccept")->click();
  EXPECT_EQ(guide_->state(1), State::Done) << "the author has looked";
}

TEST_F(Guiding, AClickOutsideTheVeinCannotBeAcceptedAway) {
  const test::TemporaryFolder folder;
  choose("vein-right");
  click({0, 12, -7});
  click({0, 12, 7});
  run();
  const int vein = guide_->current();
  EXPECT_TRUE(QTest::qWaitFor([&] { return guide_->state(vein) == State::Done; }, kPatience_ms));
  // The label is erased around the first click.
  child<QPushButton>("guideCorrect")->click();
  for (const double y_mm : {7.0, 9.0, 11.0, 13.0, 15.0, 17.0}) drag({-6, y_mm, -7}, {6, y_mm, -7}, Qt::ControlModifier);
  child<QPushButton>("guideCorrect")->click();
  child<QPushButton>("guideAccept")->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return guide_->state(vein) == State::Warning; }, kPatience_ms));
  EXPECT_THAT(guide_->remarks(vein).join(' ').toStdString(), HasSubstr("Click 1 at ("));
  saveAndOpenAgain(folder.path() / "case");
  EXPECT_TRUE(QTest::qWaitFor([&] { return guide_->state(vein) == State::Warning; }, kPatience_ms))
      << "also on another day";
}

TEST_F(Guiding, OnALowScreenItsWordsAreScrolledAndNeverCut) {
  workspace_->resize(1280, 640);  // what a window of 1280 x 720 leaves
  makeVein(kArtery_x);
  ASSERT_TRUE(QTest::qWaitFor([&] { return guide_->state(1) == State::Warning; }, kPatience_ms));
  auto* page = child<QWidget>("guide");
  const auto whole = [&] {
    const auto labels = page->findChildren<QLabel*>(QRegularExpression("^guide"));
    return std::ranges::all_of(labels, [](const QLabel* label) {
      return !label->isVisible() || label->height() >= label->heightForWidth(label->width());
    });
  };
  for (const bool corrects : {false, true}) {
    guide_->setCorrecting(corrects);
    EXPECT_TRUE(QTest::qWaitFor(whole, kPatience_ms)) << corrects;
    auto* words = child<QWidget>("guideWords");
    for (const char* name : {"guideAccept", "guideCorrect", "guideRun"}) {
      auto* button = child<QPushButton>(name);
      EXPECT_TRUE(page->rect().contains(QRect(button->mapTo(page, {}), button->size()))) << name;
      EXPECT_GE(button->mapTo(page, {}).y(), words->mapTo(page, {}).y() + words->height()) << name;
      EXPECT_GE(button->height(), button->minimumSizeHint().height()) << name;
    }
  }
}

TEST_F(Guiding, AfterAnUndoTheImageOfTheFormerLabelsIsMarked) {
  makeVein();
  const auto& view = static_cast<const views::UltrasoundView&>(child<ui::ViewWidget>("labelUltrasound")->view());
  const auto isUnmarked = [&] { return shared_->live.isSettled() && view.staleMark().empty(); };
  ASSERT_TRUE(QTest::qWaitFor(isUnmarked, kPatience_ms));
  QStringList marks;
  const auto recording = QObject::connect(&shared_->live, &LivePatient::stateChanged, workspace_.get(),
                                          [&] { marks << QString::fromStdString(view.staleMark()); });
  child<QAction>("undo")->trigger();
  EXPECT_TRUE(QTest::qWaitFor([&] { return marks.contains("Image of the previous labels"); }, kPatience_ms));
  EXPECT_TRUE(QTest::qWaitFor(isUnmarked, kPatience_ms));
  QObject::disconnect(recording);
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
  EXPECT_EQ(shared_->labeling.recipe().steps.size(), 2u) << "nothing is recorded twice";
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

  save(folder.path() / "case");
  const auto recipe = loadRecipe((folder.path() / "case" / "recipe.json").string());
  ASSERT_TRUE(recipe) << recipe.error().message;
  PatientCase imported = *unlabeled();
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
  EXPECT_EQ(child<QTabBar>("labelling")->currentIndex(), 0) << "the guide, where there is more to do";
}

/// The window states the folder of a case before the case itself, as at the program's start.
TEST_F(Guiding, ASavedCaseOpensInANewWindow) {
  const test::TemporaryFolder folder;
  makeArtery();
  save(folder.path() / "case");
  auto back = readCase(folder.path() / "case");
  ASSERT_TRUE(back) << back.error().message;

  workspace_->setCase(nullptr);
  ui::CaseOrigin origin;
  origin.folder = QString::fromStdString((folder.path() / "case").string());
  workspace_->setOrigin(origin);
  QThreadPool::globalInstance()->waitForDone();
  openCase(std::make_shared<const PatientCase>(std::move(back->patient)));
  QThreadPool::globalInstance()->waitForDone();
  EXPECT_EQ(guide_->state(2), State::Done);
}

TEST_F(Guiding, AStepThatFailsLeavesWhatWasThere) {
  makeVein();
  const std::vector<std::uint8_t> before = voxels();
  // Both clicks on one point.
  drag({0, 12, 7}, {0, 12, -7});
  choose("vein-right");
  guide_->moveClick(1, guide_->clicks_mm()[0]);
  run();
  EXPECT_THAT(child<QLabel>("guideTold")->text().toStdString(), HasSubstr("almost at the same point"));
  EXPECT_EQ(voxels(), before);
}

TEST_F(Guiding, DoingAnEarlierStepAgainKeepsColorsTitleAndPlaces) {
  makeVein(2.5);
  shared_->appearance.setColor(kVein, {1, 2, 3});
  shared_->openCase.setTitle("Mine");
  CasePlaces places = shared_->places.value();
  places.difficulty = "hard";
  shared_->places.set(places, "difficulty");
  makeArtery();
  const std::size_t artery = count(kArtery);
  ASSERT_GT(artery, 0U);
  shared_->appearance.setVisible(kBone, false);
  choose("vein-right");
  click({2.5, 12, -7}, Qt::RightButton);
  click({0, 12, -2});
  run();
  EXPECT_EQ(shared_->appearance.look(kVein).color, (views::Color{1, 2, 3}));
  EXPECT_FALSE(shared_->appearance.look(kBone).visible);
  EXPECT_EQ(shared_->openCase.title(), "Mine");
  EXPECT_EQ(shared_->places.value().difficulty, "hard");
  EXPECT_NE(guide_->state(2), State::ToDo);
  EXPECT_EQ(count(kArtery), artery) << "made again as it was";
  child<QAction>("undo")->trigger();
  EXPECT_NE(shared_->openCase.title(), "Mine") << "and it is one step to take back";
}

TEST_F(Guiding, WhatWasPaintedIsMadeAgainThoughItIsLockedNow) {
  makeVein(2.5);
  child<QPushButton>("guideCorrect")->click();
  drag({2.5, 12, 0}, {8, 20, 0});
  makeArtery();
  shared_->labeling.setLocked(kArtery, true);
  const std::size_t artery = count(kArtery);
  choose("vein-right");
  drag({2.5, 12, -7}, {1.5, 12, -7});
  run();
  EXPECT_EQ(count(kArtery), artery) << "made again, with the rules of its time";
  EXPECT_EQ(shared_->labeling.recipe().steps.size(), 3u);
  EXPECT_EQ(shared_->labeling.labels().at(shared_->labeling.labels().geometry.size[0] / 2, 0, 0),
            unlabeled()->labels.at(unlabeled()->labels.geometry.size[0] / 2, 0, 0));
  EXPECT_TRUE(shared_->labeling.rules().locked.test(kArtery));
}

TEST_F(Guiding, ClicksOnTheOtherSideAreDoubted) {
  choose("vein-left");
  click({kArtery_x, 12, -6});
  click({kArtery_x, 12, 6});
  run();
  const int left = guide_->current();
  EXPECT_TRUE(QTest::qWaitFor([&] { return guide_->state(left) == State::Warning; }, kPatience_ms));
  EXPECT_THAT(child<QLabel>("guideResult")->text().toStdString(), HasSubstr("on the patient's right"));
}

TEST_F(Guiding, LeftAndRightAreToldApartOnAnotherDay) {
  const test::TemporaryFolder folder;
  choose("vein-left");
  click({0, 12, -7});
  click({0, 12, 7});
  run();
  saveAndOpenAgain(folder.path() / "case");
  choose("vein-left");
  EXPECT_EQ(guide_->state(guide_->current()), State::Done);
  EXPECT_EQ(guide_->clicks_mm().size(), 2u);
  choose("vein-right");
  EXPECT_EQ(guide_->state(guide_->current()), State::ToDo);
  EXPECT_TRUE(guide_->clicks_mm().empty());
  EXPECT_THAT(child<QLabel>("guideSay")->text().toStdString(), HasSubstr("on the left of the slices"));
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
