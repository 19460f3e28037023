#include "PrepareWindow.h"
#include "guide/GuideSession.h"

#include <insonate/cases/CaseVersions.h>
#include <insonate/cases/Phantom.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/ui/KnownCases.h>

#include <QTabBar>
#include <QTreeWidget>
#include <utility>

namespace insonate::prepare {
namespace {

class CheckPage : public PrepareWindow {
 protected:
  QTreeWidget* places() { return child<QTreeWidget>("places"); }
  QTreeWidgetItem* item(const QString& name) {
    const auto found = places()->findItems(name, Qt::MatchExactly | Qt::MatchRecursive);
    EXPECT_EQ(found.size(), 1) << name.toStdString();
    return found.isEmpty() ? nullptr : found.front();
  }
  void press(const char* button) { child<QPushButton>(button)->click(); }
  void mark(const QString& kind) {
    auto* kinds = child<QComboBox>("placeKind");
    const int row = kinds->findText(kind);
    ASSERT_GE(row, 0) << kind.toStdString();
    kinds->setCurrentIndex(row);
    press("placeAdd");
  }
  bool checkedAgain(const std::function<bool()>& condition) {
    return QTest::qWaitFor([&] { return workspace_->isReady() && condition(); }, kPatience_ms);
  }
  bool finds(const std::string& code) {
    const auto& measures = shared_->measuring.measures();
    return measures && std::ranges::any_of(measures->findings, [&](const Finding& f) { return f.code == code; });
  }
  QStringList nextSteps() {
    QStringList next;
    for (const QLabel* label : workspace_->findChildren<QLabel*>())
      if (label->property("role") == "next" && !label->isHidden())
        for (const QLabel* heading :
             label->parentWidget()->findChildren<QLabel*>(QString(), Qt::FindDirectChildrenOnly))
          if (heading->property("role") == "heading") next << heading->text();
    return next;
  }
  QString text(const char* label) { return child<QLabel>(label)->text(); }
};

/// A case with a named vein, but without places.
std::shared_ptr<PatientCase> withoutPlaces(const PatientCase& patient) {
  auto bare = std::make_shared<PatientCase>(patient);
  bare->manifest.targets.clear(), bare->manifest.startPoses.clear(), bare->manifest.landmarks.clear();
  NamedVessel vein{"right internal jugular vein", kVein, {}};
  for (int z_mm = -8; z_mm <= 8; ++z_mm) vein.course.push_back({{0, 12, double(z_mm)}, 5});
  bare->manifest.vessels = {vein};
  return bare;
}

TEST_F(CheckPage, VerdictAndGroupsSayWhatIsMissing) {
  openCase();
  EXPECT_TRUE(text("checkVerdict").startsWith("Not fit for training")) << "no artery";
  QStringList headings;
  for (const QLabel* label : child<QWidget>("findings")->findChildren<QLabel*>())
    if (label->property("role") == "heading" || label->text().startsWith("Missing")) headings << label->text();
  EXPECT_TRUE(headings.contains("Errors")) << headings.join(", ").toStdString();
}

TEST_F(CheckPage, ALandmarkIsMarkedShownMovedNamedAndRemoved) {
  openCase();
  shared_->crosshair.moveTo({5, 6, 1});
  mark("cricoid cartilage");
  ASSERT_EQ(shared_->places.value().landmarks.size(), 1u);
  EXPECT_EQ(shared_->places.value().landmarks[0].code, "cricoid");
  EXPECT_EQ(shared_->places.value().landmarks[0].position_mm, (Vec3{5, 6, 1}));
  EXPECT_TRUE(workspace_->unsavedEdit());

  shared_->crosshair.moveTo({-5, 8, 2});
  places()->setCurrentItem(item("cricoid cartilage"));
  press("placeShow");
  EXPECT_EQ(shared_->crosshair.position_mm(), (Vec3{5, 6, 1}));
  shared_->crosshair.moveTo({-5, 8, 2});
  press("placePut");
  EXPECT_EQ(shared_->places.value().landmarks[0].position_mm, (Vec3{-5, 8, 2}));
  item("cricoid cartilage")->setText(0, "cricoid, front");
  EXPECT_TRUE(QTest::qWaitFor([&] { return shared_->places.value().landmarks[0].name == "cricoid, front"; }));
  places()->setCurrentItem(item("cricoid, front"));
  press("placeRemove");
  EXPECT_TRUE(shared_->places.value().landmarks.empty());
  for (int n = 0; n < 4; ++n) shared_->openCase.undoStack().undo();
  EXPECT_FALSE(workspace_->unsavedEdit()) << "each was taken back";
}

TEST_F(CheckPage, ALandmarkThatIsMarkedAgainMovesAndAnotherOneIsAnother) {
  openCase();
  for (const char* kind : {"cricoid cartilage", "right clavicle, inner end"}) mark(kind);
  shared_->crosshair.moveTo({-5, 8, 2});
  mark("cricoid cartilage");
  ASSERT_EQ(shared_->places.value().landmarks.size(), 2u) << "a neck has one cricoid";
  EXPECT_EQ(shared_->places.value().landmarks[0].position_mm, (Vec3{-5, 8, 2}));
  EXPECT_EQ(shared_->statusLine.text(),
            "\"cricoid cartilage\" existed already and was moved to the crosshair; Ctrl+Z undoes the move.");
  shared_->openCase.undoStack().undo();
  ASSERT_EQ(shared_->places.value().landmarks.size(), 2u);
  EXPECT_NE(shared_->places.value().landmarks[0].position_mm, (Vec3{-5, 8, 2}));
  for (int n = 0; n < 2; ++n) mark("another landmark");
  EXPECT_EQ(shared_->places.value().landmarks.size(), 4u) << "what the author names may be there twice";
}

TEST_F(CheckPage, ATargetGoesIntoAVesselOnlyAndTheCheckFollows) {
  auto without = std::make_shared<PatientCase>(*patient());
  without->manifest.targets.clear();
  openCase(without);
  EXPECT_TRUE(finds("no_target"));
  shared_->crosshair.moveTo({20, 20, 0});
  mark("target of the puncture");
  EXPECT_TRUE(shared_->places.value().targets.empty());
  EXPECT_TRUE(workspace_->statusText().contains("vein or an artery"));
  shared_->crosshair.moveTo({0, 12, 0});
  mark("target of the puncture");
  ASSERT_EQ(shared_->places.value().targets.size(), 1u);
  EXPECT_EQ(shared_->places.value().targets[0].label, kVein);
  EXPECT_TRUE(checkedAgain([this] { return !finds("no_target"); })) << "without being asked";
}

TEST_F(CheckPage, MissingPlacesAreProposedAndCanBeUndone) {
  auto without = std::make_shared<PatientCase>(*patient());
  const Target target = without->manifest.targets.front();
  without->manifest.targets.clear(), without->manifest.startPoses.clear(), without->manifest.vessels.clear();
  openCase(without);
  press("placePropose");
  ASSERT_TRUE(QTest::qWaitFor([&] { return workspace_->statusText().contains("Name the vein first"); }, kPatience_ms));

  openCase(withoutPlaces(*patient()));
  press("placePropose");
  const auto& places = shared_->places.value();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !places.targets.empty(); }, kPatience_ms));
  EXPECT_EQ(places.targets.front().name, "right internal jugular vein");
  EXPECT_EQ(places.startPoses.size(), 2 * places.targets.size());
  EXPECT_EQ(places.landmarks.size(), 1U);
  EXPECT_LT(norm(places.targets.front().position_mm - target.position_mm), 9);
  EXPECT_EQ(shared_->crosshair.position_mm(), places.targets.front().position_mm);
  EXPECT_TRUE(checkedAgain([this] { return !finds("no_target") && !finds("no_start_pose"); }));
  press("placePropose");
  EXPECT_TRUE(QTest::qWaitFor([&] { return workspace_->statusText().contains("Nothing is missing"); }, kPatience_ms));
  shared_->openCase.undoStack().undo();
  EXPECT_TRUE(places.targets.empty() && places.startPoses.empty() && places.landmarks.empty());
}

TEST_F(CheckPage, TheFirstOpenStepIsMarkedAsNext) {
  openCase();
  EXPECT_EQ(nextSteps(), QStringList{"1  Import"}) << "the case is not on disk";
  ui::CaseOrigin saved;
  saved.folder = QStringLiteral("/somewhere/neck");
  workspace_->setOrigin(saved);
  EXPECT_EQ(nextSteps(), QStringList{"2  Label"}) << "an artery is missing";
  ui::CaseOrigin version;
  version.versionOf = saved.folder;
  workspace_->setOrigin(version);
  EXPECT_FALSE(nextSteps().contains("4  Publish")) << "only the current case can be published";
}

TEST_F(CheckPage, TheFindingOfAMissingTargetProposesIt) {
  openCase(withoutPlaces(*patient()));
  ASSERT_TRUE(finds("no_target"));
  press("propose-no_target");
  EXPECT_TRUE(checkedAgain([this] { return !finds("no_target") && !finds("no_start_pose"); }));
}

TEST_F(CheckPage, TheGuideProposesPlacesAfterTheLabels) {
  openCase(withoutPlaces(*patient()));
  auto& guide = *workspace_->findChild<GuideSession*>();
  const int last = int(std::ranges::find(guide.steps(), "places", &GuideStep::name) - guide.steps().begin());
  ASSERT_LT(last, int(guide.steps().size()));
  EXPECT_EQ(guide.state(last), GuideSession::State::ToDo);
  guide.go(last);
  EXPECT_FALSE(guide.takesClicks());
  press("guideRun");
  EXPECT_EQ(guide.state(last), GuideSession::State::Working);
  EXPECT_FALSE(child<QPushButton>("guideRun")->isEnabled());
  ASSERT_TRUE(QTest::qWaitFor([&] { return guide.state(last) == GuideSession::State::Done; }, kPatience_ms));
  EXPECT_EQ(shared_->places.value().startPoses.size(), 2U);
  shared_->openCase.undoStack().undo();
  EXPECT_EQ(guide.state(last), GuideSession::State::ToDo) << "undo removes the places";
}

TEST_F(CheckPage, AVesselIsNamedShownSplitRenamedAndRemoved) {
  auto without = std::make_shared<PatientCase>(*patient());
  without->manifest.vessels.clear();
  openCase(without);
  EXPECT_TRUE(finds("no_vessel_names"));
  const auto& vessels = shared_->places.value().vessels;
  shared_->crosshair.moveTo({20, 20, 0});
  mark("right internal jugular vein");
  EXPECT_TRUE(QTest::qWaitFor([&] { return workspace_->statusText().contains("no vein or artery"); }, kPatience_ms));
  EXPECT_TRUE(vessels.empty());
  shared_->crosshair.moveTo({0, 12, 0});
  mark("right internal jugular vein");
  ASSERT_TRUE(QTest::qWaitFor([&] { return vessels.size() == 1; }, kPatience_ms));
  EXPECT_LT(distanceToCenterLine_mm(vessels[0], {0, 12, 0}), 1);
  EXPECT_TRUE(checkedAgain([this] { return !finds("no_vessel_names"); }));

  places()->setCurrentItem(item("right internal jugular vein"));
  press("placeSplit");
  ASSERT_EQ(vessels.size(), 2u);
  EXPECT_EQ(vessels[1].name, "right internal jugular vein, part 2");
  EXPECT_EQ(vessels[0].course.back(), vessels[1].course.front());
  item("right internal jugular vein, part 2")->setText(0, "right brachiocephalic vein");
  ASSERT_TRUE(QTest::qWaitFor([&] { return vessels[1].name == "right brachiocephalic vein"; }, kPatience_ms));
  places()->setCurrentItem(item("right brachiocephalic vein"));
  press("placeRemove");
  EXPECT_EQ(vessels.size(), 1u);
  mark("target of the puncture");
  EXPECT_EQ(shared_->places.value().targets.back().name, "right internal jugular vein");
  for (int n = 0; n < 5; ++n) shared_->openCase.undoStack().undo();
  EXPECT_TRUE(vessels.empty()) << "each can be undone";
}

TEST_F(CheckPage, StartPosesAreSeveralAndOneIsTheFirst) {
  openCase();
  shared_->crosshair.moveTo({10, 1, 0});
  ASSERT_TRUE(QTest::qWaitFor([&] { return workspace_->isReady(); }, kPatience_ms));
  mark("start pose of the probe");
  ASSERT_EQ(shared_->places.value().startPoses.size(), 2u);
  EXPECT_NEAR(shared_->places.value().startPoses[1].position_mm.x, 10, 1.5);
  places()->setCurrentItem(item("start 2"));
  press("placeFirst");
  EXPECT_EQ(shared_->places.value().startPoses[0].name, "start 2");
  EXPECT_EQ(shared_->live.start()->name, "start 2");
  PatientCase copy = *patient();
  workspace_->unsavedEdit()(copy);
  EXPECT_EQ(copy.manifest.startPoses[0].name, "start 2");
  EXPECT_EQ(copy.manifest.startPoses[1].name, "over the vein");
  shared_->crosshair.moveTo({-10, 1, 0});
  shared_->crosshair.goToStart();
  EXPECT_NEAR(shared_->live.standing()->offset.x, 10, 1.5);
}

TEST_F(CheckPage, DifficultyShowsItsMeasuresAndTheAuthorsGradeGoesBefore) {
  openCase();
  EXPECT_TRUE(text("gradeSentence").startsWith("Estimated difficulty. ")) << text("gradeSentence").toStdString();
  // Skin from -0.5 mm, vein from 7.5 mm: voxels begin half before their middles.
  EXPECT_TRUE(text("gradeMeasures").contains("depth of the vein: 8.0 mm")) << text("gradeMeasures").toStdString();
  auto* grade = child<QComboBox>("grade");
  EXPECT_EQ(grade->currentText(), "estimated difficulty");
  grade->setCurrentIndex(grade->findText("hard"));
  Q_EMIT grade->activated(grade->currentIndex());
  EXPECT_EQ(shared_->places.value().difficulty, "hard");
  EXPECT_TRUE(checkedAgain([this] { return finds("difficulty_differs"); }));
  shared_->openCase.undoStack().undo();
  EXPECT_EQ(grade->currentText(), "estimated difficulty");
}

TEST_F(CheckPage, PressingFlattensTheVeinAndIsNotKeptAsTheStart) {
  auto without = std::make_shared<PatientCase>(*patient());
  without->manifest.startPoses.clear();
  openCase(without);
  ASSERT_TRUE(shared_->live.standing());
  child<ui::ValueSlider>("press")->setValue(6);
  const auto pressed = [&] {
    const auto frame = shared_->live.shown();
    if (!frame || frame->press.force_N <= 0) return false;
    return std::ranges::any_of(frame->press.lumens, [](const LumenArea& lumen) {
      return lumen.label == kVein && lumen.area_mm2 < 0.8 * lumen.rest_mm2;
    });
  };
  EXPECT_TRUE(QTest::qWaitFor(pressed, kPatience_ms)) << text("pressed").toStdString();
  EXPECT_TRUE(text("pressed").contains("vein")) << text("pressed").toStdString();
  EXPECT_TRUE(text("pressed").contains(" N"));
  press("keepStart");
  ASSERT_EQ(shared_->places.value().startPoses.size(), 1u);
  EXPECT_NEAR(shared_->places.value().startPoses[0].position_mm.y, 0, 1) << "on the skin, not in it";
  openCase();
  EXPECT_EQ(child<ui::ValueSlider>("press")->value(), 0) << "another case is not pressed";
}

TEST_F(CheckPage, AKeyAndThePathOfStepsLeadToItAndBack) {
  openCase();
  EXPECT_FALSE(child<QWidget>("checkVerdict")->isVisible());
  EXPECT_TRUE(child<QLineEdit>("caseTitle")->isVisible());
  key(Qt::Key_C);
  EXPECT_TRUE(child<QWidget>("checkVerdict")->isVisible());
  EXPECT_FALSE(child<QLineEdit>("caseTitle")->isVisible());
  key(Qt::Key_C);
  EXPECT_TRUE(child<QLineEdit>("caseTitle")->isVisible());
  press("toFindings");
  EXPECT_TRUE(child<QWidget>("checkVerdict")->isVisible());
  EXPECT_EQ(child<QTabBar>("rightPages")->currentIndex(), 1);
}

TEST_F(CheckPage, WhatIsMissingLeadsToWhereItIsMade) {
  auto without = std::make_shared<PatientCase>(*patient());
  without->manifest.targets.clear();
  openCase(without);
  press("toFindings");
  child<QTabBar>("labelling")->setCurrentIndex(1);
  press("place-no_artery");
  EXPECT_EQ(child<QTabBar>("labelling")->currentIndex(), 0) << "the guide";
  EXPECT_EQ(workspace_->findChild<GuideSession*>()->step().name, "artery-right");
  press("place-no_target");
  EXPECT_EQ(child<QTabBar>("labelling")->currentIndex(), 1) << "the guide would take the clicks that say where";
  EXPECT_EQ(child<QComboBox>("placeKind")->currentText(), "target of the puncture");
}

class Publish : public CheckPage {
 protected:
  /// A case of a size that is fit for training.
  static std::shared_ptr<const PatientCase> fit() {
    static const auto made = std::make_shared<const PatientCase>(*makePhantom("textbook", 1));
    return made;
  }
  QString why() { return child<QPushButton>("publish")->toolTip(); }
  bool enabled() { return child<QPushButton>("publish")->isEnabled(); }
  void setFolder(const std::filesystem::path& folder) {
    ui::CaseOrigin origin;
    origin.folder = QString::fromStdString(folder.string());
    workspace_->setOrigin(origin);
  }
};

TEST_F(Publish, WhatStandsAgainstItIsSaid) {
  EXPECT_FALSE(enabled());
  openCase();
  EXPECT_TRUE(why().contains("Save the case first")) << why().toStdString();
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writeCase(*patient(), folder.path() / "case"));
  setFolder(folder.path() / "case");
  EXPECT_TRUE(why().contains("not fit for training")) << why().toStdString();
  EXPECT_FALSE(enabled());
  ui::CaseOrigin kept;
  kept.versionOf = "/somewhere";
  workspace_->setOrigin(kept);
  EXPECT_TRUE(why().contains("earlier version")) << why().toStdString();
}

TEST_F(Publish, TraineesGetWhatWasPublishedWhateverIsSavedLater) {
  const test::TemporaryFolder folder;
  const auto place = folder.path() / "case";
  ASSERT_TRUE(saveCaseVersion(*fit(), place, "2026-11-22", ""));
  setFolder(place);
  openCase(fit());
  ASSERT_TRUE(enabled()) << why().toStdString();
  EXPECT_EQ(nextSteps(), QStringList{"4  Publish"});
  press("publish");
  ASSERT_TRUE(QTest::qWaitFor([&] { return publishedVersion(place) == 1; }, kPatience_ms));
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return workspace_->statusText().contains("The case is published"); }, kPatience_ms));
  EXPECT_EQ(nextSteps(), QStringList()) << "nothing is left to do";

  shared_->structures.removeVoxels(kThyroid);
  ASSERT_TRUE(QTest::qWaitFor([&] { return workspace_->unsavedEdit() && workspace_->isReady(); }, kPatience_ms));
  EXPECT_FALSE(enabled()) << "not saved";
  PatientCase changed = *fit();
  workspace_->unsavedEdit()(changed);
  ASSERT_TRUE(saveCaseVersion(changed, place, "2026-11-23", ""));
  const auto trained = readCase(ui::trainingLocation(QString::fromStdString(place.string())).toStdString());
  ASSERT_TRUE(trained) << trained.error().message;
  EXPECT_TRUE(trained->patient.labels.voxels == fit()->labels.voxels);
}

TEST_F(CheckPage, TheProbeStandsOnTheSkinAsItIsEdited) {
  openCase();
  ASSERT_TRUE(shared_->live.standing());
  const Vec3 before_mm = shared_->live.standing()->offset;
  LabelStep cut;
  cut.tool = step::Paint{.points_mm = {before_mm - Vec3{0, 12, 0}}, .radius_mm = 18};
  cut.label = kBackground;
  std::optional<Result<LabelChange>> made;
  shared_->labeling.run(std::move(cut), "cut", [&](const Result<LabelChange>& change) { made = change; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return made.has_value(); }, kPatience_ms));
  ASSERT_TRUE(*made) << made->error().message;
  ASSERT_TRUE((*made)->labels.test(kBackground)) << (*made)->voxels;
  ASSERT_TRUE(QTest::qWaitFor([&] { return shared_->live.standing()->offset.y > before_mm.y + 3; }, kPatience_ms))
      << shared_->live.standing()->offset.y;
}

TEST_F(CheckPage, AFindingSelectsItsStructure) {
  auto crumbs = std::make_shared<PatientCase>(*patient());
  crumbs->labels.at(40, 30, 8) = kVein;
  openCase(crumbs);
  shared_->structures.select(kBone);
  press("place-vein_fragments");
  EXPECT_EQ(shared_->structures.selected(), kVein);
  EXPECT_EQ(shared_->crosshair.position_mm(), (Vec3{16, 24, 0}));
}

}  // namespace
}  // namespace insonate::prepare
