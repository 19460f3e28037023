#include "AttemptWindow.h"
#include "attempt/SyringeView.h"
#include "patient3d/PatientViews.h"
#include "patient3d/SceneNeedle.h"

#include <insonate/cases/CaseVersions.h>
#include <insonate/cases/Phantom.h>
#include <insonate/simulator/AttemptSettings.h>
#include <insonate/tissue/Labels.h>
#include <insonate/ui/ViewWidget.h>
#include <insonate/views/SceneView.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace insonate::train {
namespace {

using State = AttemptControl::State;

class TrainAttempt : public AttemptWindow {
 protected:
  views::SceneView& scene() { return static_cast<views::SceneView&>(child<ui::ViewWidget>("sceneView")->view()); }
};

TEST_F(TrainAttempt, ACaseBringsItsOwnProcedure) {
  const auto targeting = [](const std::string& vein) {
    PatientCase made = wideCase();
    made.manifest.targets = {{vein, kVein, {0, 12, 0}}};
    made.manifest.vessels = {{vein, kVein, {{{0, 12, -25}, 4.5}, {{0, 12, 25}, 4.5}}}};
    return std::make_shared<const PatientCase>(std::move(made));
  };
  open(targeting("right common femoral vein"));
  EXPECT_TRUE(waitFor([&] { return attempt_->procedure().name == "femoral"; })) << attempt_->procedure().name;
  EXPECT_TRUE(attempt_->unfit().isEmpty()) << attempt_->unfit().toStdString();
  EXPECT_EQ(child<QComboBox>("attemptProcedure")->currentText().toStdString(), attempt_->procedure().title);
  attempt_->choose("femoral_line");
  open(targeting("left common femoral vein"));
  ASSERT_TRUE(waitFor([&] { return model_->patientCase.structures().has_value(); }));
  EXPECT_EQ(attempt_->procedure().name, "femoral_line") << "it fits this case, too";
  open(targeting("right internal jugular vein"));
  EXPECT_TRUE(waitFor([&] { return attempt_->procedure().name == "internal_jugular"; })) << attempt_->procedure().name;
}

/// On a laptop's screen an attempt's panel pushes the needle's section of the left column out of sight.
TEST_F(TrainAttempt, TheNeedleIsAtHandUnderTheImage) {
  workspace_->resize(1366, 700);
  openWide();
  EXPECT_FALSE(shown("needleStrip"));
  start();
  ASSERT_TRUE(shown("needleStrip"));
  auto *along = child<QPushButton>("stripAlong"), *advance = child<QPushButton>("needleAdvance");
  for (const char* name :
       {"stripAlong", "stripAcross", "needleFlatter", "needleSteeper", "needleWithdraw", "needleAdvance"}) {
    auto* button = child<QPushButton>(name);
    EXPECT_EQ(button->visibleRegion().boundingRect(), button->rect()) << name << " is cut";
    EXPECT_GE(button->width(), button->minimumSizeHint().width()) << name;
  }
  EXPECT_FALSE(advance->isEnabled());

  along->click();
  ASSERT_TRUE(hands().needleHand());
  EXPECT_TRUE(along->isChecked());
  const double angle_deg = held().angle_deg, advance_mm = hands().wantedAdvance_mm();
  child<QPushButton>("needleSteeper")->click();
  EXPECT_NEAR(held().angle_deg, angle_deg + 1, 1e-9);
  child<QPushButton>("needleFlatter")->click();
  EXPECT_NEAR(held().angle_deg, angle_deg, 1e-9);
  advance->click();
  EXPECT_NEAR(hands().wantedAdvance_mm(), advance_mm + 1, 1e-9);
  child<QPushButton>("needleWithdraw")->click();
  EXPECT_NEAR(hands().wantedAdvance_mm(), advance_mm, 1e-9);
  EXPECT_TRUE(advance->toolTip().contains("Page Down")) << advance->toolTip().toStdString();
  along->click();
  EXPECT_FALSE(hands().needleHand());

  key(Qt::Key_B);
  EXPECT_FALSE(attempt_->isAspirating()) << "the syringe is on the needle";
  EXPECT_FALSE(child<QPushButton>("attemptDraw")->isChecked());
  EXPECT_TRUE(workspace_->statusText().contains("Take the needle")) << workspace_->statusText().toStdString();
  key(Qt::Key_U);
  EXPECT_TRUE(hands().needleHand()) << "a new needle is in the hand";
  finish();
  EXPECT_FALSE(shown("needleStrip"));
}

TEST_F(TrainAttempt, AWholeOneByKeysIsGuidedScoredAndKept) {
  openWide();
  EXPECT_TRUE(shown("attemptStart"));
  EXPECT_FALSE(shown("attemptStrip"));
  start();
  EXPECT_FALSE(shown("attemptStart"));
  EXPECT_TRUE(shown("attemptStrip"));
  EXPECT_TRUE(text("attemptDue").contains("Position the patient")) << text("attemptDue").toStdString();

  auto* positions = child<QComboBox>("attemptPosition");
  const int tilted = positions->findText("Trendelenburg 15");
  ASSERT_GE(tilted, 0);
  positions->setCurrentIndex(tilted);
  Q_EMIT positions->activated(tilted);
  EXPECT_EQ(model_->imaging.tissue().body.tilt_deg, 15);
  EXPECT_TRUE(waitFor([&] { return text("attemptDue").contains("Find the vein"); }));
  for (int i = 0; i < 20; ++i) key(Qt::Key_Plus);
  EXPECT_TRUE(waitFor([&] { return text("attemptDue").contains("Puncture the skin"); })) << "the vein is compressed";
  for (int i = 0; i < 20; ++i) key(Qt::Key_Minus);

  overTheVein();
  type("needle_depth", "12");
  ASSERT_TRUE(waitFor([&] { return attempt_->view().needle == NeedlePlace::Vein; }));
  EXPECT_TRUE(waitFor([&] { return text("attemptNeedle").contains("in the vein"); }));
  EXPECT_EQ(text("attemptVein"), "vein 1");
  key(Qt::Key_B);
  EXPECT_TRUE(child<QPushButton>("attemptDraw")->isChecked());
  auto* syringe = workspace_->findChild<SyringeView*>();
  EXPECT_TRUE(waitFor([&] { return syringe->content() == SyringeView::Content::DarkBlood && syringe->level() > 0.1; }));
  EXPECT_TRUE(waitFor([&] { return text("attemptDue").contains("Freeze and inspect"); }));
  key(Qt::Key_B);
  key(Qt::Key_Space);
  EXPECT_TRUE(waitFor([&] { return text("attemptDue").contains("Withdraw"); }));
  key(Qt::Key_Space);
  type("needle_depth", "-5");
  EXPECT_TRUE(waitFor([&] { return text("attemptDue").contains("All steps are done"); }));
  EXPECT_TRUE(text("attemptNeedle").contains("needle is already used"));
  key(Qt::Key_U);
  EXPECT_TRUE(waitFor([&] { return text("attemptNeedle").contains("needle is new"); }));
  EXPECT_EQ(syringe->content(), SyringeView::Content::Nothing);
  finish();

  EXPECT_TRUE(text("attemptHeadline").contains("of 100 points: the attempt succeeded"))
      << text("attemptHeadline").toStdString();
  QString reviewed;
  QObject::connect(workspace_.get(), &TrainWorkspace::attemptRequested, [&](const QString& file) { reviewed = file; });
  child<QPushButton>("attemptReview")->click();
  EXPECT_EQ(QFileInfo(reviewed).absolutePath(), QFileInfo(folder()).absoluteFilePath());
  const auto recording = recorded();
  ASSERT_TRUE(recording) << recording.error().message;
  EXPECT_EQ(recording->status(), AttemptStatus::Completed);
  EXPECT_EQ(recording->header().procedure, "internal_jugular");
  EXPECT_EQ(recording->header().caseHash.size(), 16U);
  EXPECT_EQ(*recording->metricsUntil(), attempt_->view().metrics) << "replayed to the last bit";
  std::vector<AttemptEvent> events;
  EXPECT_TRUE(recording->play(recording->end_us(), [&](const RecordingSegment::Entry& entry) {
    if (const auto* event = std::get_if<AttemptEvent>(&entry)) events.push_back(*event);
  }));
  EXPECT_EQ(events, attempt_->view().events);
  child<QPushButton>("attemptLeave")->click();
  EXPECT_TRUE(shown("attemptStart"));
}

TEST_F(TrainAttempt, ADoublePressOfTheStartKeyFinishesNothing) {
  openWide();
  start();
  key(Qt::Key_Return, Qt::ControlModifier);
  EXPECT_TRUE(attempt_->isRunning());
  EXPECT_TRUE(workspace_->statusText().startsWith("The attempt has just begun"))
      << workspace_->statusText().toStdString();
  finish();
}

TEST_F(TrainAttempt, AProcedureThatTheCaseIsNotForIsToldAndDoesNotBegin) {
  openWide();
  ASSERT_TRUE(waitFor([&] { return child<QPushButton>("attemptStart")->isEnabled(); }));
  EXPECT_FALSE(shown("attemptUnfit"));
  auto* procedure = child<QComboBox>("attemptProcedure");
  const auto choose = [&](const char* name) {
    procedure->setCurrentIndex(procedure->findData(name));
    Q_EMIT procedure->activated(procedure->currentIndex());
  };
  choose("subclavian");
  EXPECT_TRUE(shown("attemptUnfit"));
  EXPECT_TRUE(text("attemptUnfit").contains("nothing is labeled airway and lung"));
  EXPECT_FALSE(child<QPushButton>("attemptStart")->isEnabled());
  key(Qt::Key_Return, Qt::ControlModifier);
  EXPECT_EQ(attempt_->state(), State::Idle);
  EXPECT_TRUE(workspace_->statusText().contains("a pneumothorax would not be noticed"));
  choose("internal_jugular");
  EXPECT_FALSE(shown("attemptUnfit"));
  start();
}

TEST_F(TrainAttempt, ACaseThatIsSavedMeanwhileComesAfterTheAttempt) {
  openWide();
  start();
  const auto before = model_->patientCase.patient();
  auto edited = std::make_shared<PatientCase>(*before);
  std::ranges::replace(edited->labels.voxels, std::uint8_t{kVein}, std::uint8_t{kMuscle});
  workspace_->caseSaved(edited);
  EXPECT_EQ(model_->patientCase.patient(), before);
  EXPECT_TRUE(workspace_->statusText().contains("the former version")) << workspace_->statusText().toStdString();
  QTest::qWait(300);
  EXPECT_TRUE(attempt_->isRunning());
  finish();
  EXPECT_EQ(model_->patientCase.patient(), before) << "its result still stands there";
  child<QPushButton>("attemptLeave")->click();
  ASSERT_TRUE(waitFor([&] { return model_->patientCase.patient() == edited; }));
  EXPECT_EQ(recorded()->header().caseHash, voxelHashOf(*before));
}

TEST_F(TrainAttempt, WhatWentWrongIsSaidWithWhatToDo) {
  openWide();
  start();
  overTheVein();
  type("needle_depth", "22");
  EXPECT_TRUE(waitFor([&] { return text("attemptStanding").contains("through the posterior wall"); }));
  EXPECT_TRUE(text("attemptStanding").contains("Major")) << text("attemptStanding").toStdString();
  EXPECT_TRUE(waitFor([&] { return text("attemptNeedle").contains("wrong place"); }));
  key(Qt::Key_U);
  EXPECT_TRUE(workspace_->statusText().contains("Withdraw the needle"));
  child<QPushButton>("attemptAbandon")->click();
  ASSERT_TRUE(waitFor([&] { return attempt_->state() == State::Over; }));
  EXPECT_EQ(text("attemptHeadline"), "Abandoned");
  EXPECT_EQ(recorded()->status(), AttemptStatus::Abandoned);
}

TEST_F(TrainAttempt, ATestIsSilentAndWithoutTheCt) {
  openWide();
  attempt_->setAssistance(Assistance::Test);
  start();
  EXPECT_FALSE(shown("attemptDue"));
  EXPECT_FALSE(shown("attemptVein"));
  EXPECT_FALSE(shown("sceneTab"));
  key(Qt::Key_C);
  EXPECT_TRUE(workspace_->statusText().contains("CT and anatomy are hidden"));
  overTheVein();
  said_.clear();
  type("needle_depth", "12");
  ASSERT_TRUE(waitFor([&] { return attempt_->view().needle == NeedlePlace::Vein; }));
  QTest::qWait(150);
  EXPECT_EQ(heard("Vein"), 0);
  EXPECT_TRUE(text("attemptNeedle").contains("needle is inserted"));
  EXPECT_FALSE(text("needleWords").contains("vein")) << text("needleWords").toStdString();
  finish();
  EXPECT_TRUE(shown("sceneTab"));
}

TEST_F(TrainAttempt, AgainBeginsAnotherAndLeavingTheCaseKeepsWhatWasMade) {
  openWide();
  start();
  overTheVein();
  child<QPushButton>("attemptAgain")->click();
  ASSERT_TRUE(waitFor([&] { return attempt_->isRunning() && files().size() >= 2; })) << files().join(' ').toStdString();
  EXPECT_FALSE(hands().needleHand()) << "laid down";
  EXPECT_EQ(files().filter(".part").size(), 1);
  workspace_->setCase(nullptr);
  EXPECT_EQ(attempt_->state(), State::Writing) << "another thread finishes the recording";
  ASSERT_TRUE(waitFor([&] { return attempt_->state() == State::Idle; }));
  EXPECT_EQ(files().size(), 2);
  EXPECT_TRUE(files().filter(".part").isEmpty()) << "both are whole";
  openWide();
  start();
  workspace_ = nullptr;
  EXPECT_EQ(files().size(), 3);
  EXPECT_TRUE(files().filter(".part").isEmpty());
}

/// Without tissue, a needle would go through the neck without a puncture.
TEST_F(TrainAttempt, BeginsOnlyWhenTheTissueForTheNeedleIsThere) {
  openWide();
  bool isThere = false;
  QObject::connect(attempt_, &AttemptControl::begun, workspace_.get(),
                   [&] { isThere = hands().session().isTissueGridReady(); });
  const auto patient = model_->patientCase.patient();
  const auto hand = ProbePlacement::make(patient->labels, model_->motion.pose());
  ASSERT_TRUE(hand) << hand.error().message;
  hands().setCase(patient, model_->patientCase.tissueLabels(), &*hand);
  ASSERT_FALSE(hands().session().isTissueGridReady());
  start();
  EXPECT_TRUE(isThere);
}

/// The product's own neck, with no other help than the keys: in the plane of the image, aimed at the vein.
TEST_F(TrainAttempt, OnTheBuiltInNeckByKeysAlone) {
  auto neck = makePhantom(phantomVariants().front().name, 1);
  ASSERT_TRUE(neck);
  workspace_->setCase(std::make_shared<const PatientCase>(std::move(*neck)));
  ASSERT_TRUE(waitFor([&] { return workspace_->isReady() && model_->motion.isReady(); }));
  ASSERT_TRUE(waitFor([&] { return hands().session().isTissueGridReady(); }));
  start();
  for (int i = 0; i < 3; ++i) key(Qt::Key_Left);
  // The vein must be seen before it is compressed: keys of a test are faster than images.
  const auto isCentered = [](const AttemptEvent& event) { return event.kind == AttemptEventKind::Centered; };
  EXPECT_TRUE(waitFor([&] { return std::ranges::any_of(attempt_->view().events, isCentered); }));
  for (int i = 0; i < 20; ++i) key(Qt::Key_Plus);
  EXPECT_TRUE(waitFor([&] { return attempt_->view().steps[1].state == ProcedureRun::StepState::Done; }));
  for (int i = 0; i < 20; ++i) key(Qt::Key_Minus);
  key(Qt::Key_I);
  // Steeper until it points at the vein, as seen in the image.
  const Vec3 vein_mm = model_->patientCase.patient()->manifest.targets.front().position_mm;
  const auto off_mm = [&] {
    const Transform needle = hands().needleHand()->patientFromNeedle();
    return norm(cross(needle.linear.column[2], vein_mm - needle.offset));
  };
  for (double before_mm = 1e9; off_mm() < before_mm;) before_mm = off_mm(), key(Qt::Key_W, Qt::AltModifier);
  EXPECT_LT(off_mm(), 3);
  key(Qt::Key_B);
  for (int i = 0; i < 6; ++i) key(Qt::Key_PageDown, Qt::ShiftModifier);
  for (int i = 0; i < 2; ++i) key(Qt::Key_PageDown);
  ASSERT_TRUE(waitFor([&] { return attempt_->view().needle == NeedlePlace::Vein; }));
  EXPECT_TRUE(waitFor([&] { return text("attemptDue").contains("Freeze and inspect"); }));
  key(Qt::Key_B);
  key(Qt::Key_Space);
  key(Qt::Key_Space);
  for (int i = 0; i < 7; ++i) key(Qt::Key_PageUp, Qt::ShiftModifier);
  EXPECT_TRUE(waitFor([&] { return text("attemptDue").contains("All steps are done"); }));
  finish();
  const MetricValues& metrics = attempt_->view().metrics;
  EXPECT_TRUE(attempt_->score().succeeded) << attempt_->score().advice;
  EXPECT_EQ(metrics[Metric::VeinPunctures], 1);
  EXPECT_EQ(metrics[Metric::ArteryPunctures], 0);
  EXPECT_EQ(metrics[Metric::Passes], 1);
  EXPECT_NEAR(*metrics[Metric::InsertionAngle], 45, 15);
  EXPECT_EQ(*recorded()->metricsUntil(), metrics);
}

TEST_F(TrainAttempt, TheSettingsOfThePicturesAreKeptAndEachChangeOfThem) {
  openWide();
  start();
  ImagingSettings brighter = model_->imaging.settings();
  brighter.gain_dB = 7;
  model_->imaging.setSettings(brighter);
  TissueChoice tilted = model_->imaging.tissue();
  tilted.body.tilt_deg = 10;
  model_->imaging.setTissue(tilted);
  finish();
  const auto recording = recorded();
  const auto begun = parseAttemptSettings(recording->header().settings);
  ASSERT_TRUE(begun) << begun.error().message;
  EXPECT_EQ(begun->setup.settings.gain_dB, brighter.gain_dB - 7);
  EXPECT_EQ(begun->setup.engine, "cpu");
  ASSERT_FALSE(recording->settingsChanges().empty());
  const auto last = parseAttemptSettings(recording->settingsChanges().back().settings);
  ASSERT_TRUE(last);
  EXPECT_EQ(last->setup.settings.gain_dB, 7);
  EXPECT_EQ(last->physiology.tilt_deg, 10);
}

/// A device that is lost takes the needle along.
TEST_F(TrainAttempt, ANeedleThatIsTakenAwayInTheBodyWasPulledOut) {
  openWide();
  start();
  for (int pass = 1; pass <= 2; ++pass) {
    overTheVein();
    type("needle_depth", "12");
    ASSERT_TRUE(waitFor([&] { return attempt_->view().needle == NeedlePlace::Vein; })) << pass;
    EXPECT_EQ(attempt_->view().metrics[Metric::Passes], pass);
    hands().removeNeedle();
    ASSERT_TRUE(waitFor([&] { return attempt_->view().needle == NeedlePlace::Used; })) << pass;
    EXPECT_TRUE(waitFor([&] { return !scene().needle(); })) << "nor is it left in 3D";
  }
}

TEST_F(TrainAttempt, TouchingTheTrayTakesANewNeedle) {
  openWide();
  start();
  overTheVein();
  type("needle_depth", "12");
  ASSERT_TRUE(waitFor([&] { return attempt_->view().needle == NeedlePlace::Vein; }));
  type("needle_depth", "-5");
  ASSERT_TRUE(waitFor([&] { return attempt_->view().needle == NeedlePlace::Used; }));
  auto* scene = workspace_->findChild<ui::ViewWidget*>("sceneView");
  const auto& patient = *static_cast<PatientViews*>(scene->parentWidget()->parentWidget());
  ASSERT_TRUE(patient.needle().tray());
  EXPECT_TRUE(patient.needle().isOnTray(*patient.needle().tray() * Vec3{50, 10, 3}));
  EXPECT_FALSE(patient.needle().isOnTray(*patient.needle().tray() * Vec3{50, 30, 3}));
  EXPECT_FALSE(patient.needle().isOnTray(*patient.needle().tray() * Vec3{0, 0, 60}));
  const views::DisplayPoint at =
      const_cast<PatientViews&>(patient).scene().displayFromPatient(patient.needle().tray()->offset);
  QWidget* canvas = scene->focusProxy();
  const QPointF where(at.x / canvas->devicePixelRatioF(), at.y / canvas->devicePixelRatioF());
  EXPECT_TRUE(QRectF(canvas->rect()).contains(where)) << "the tray is in sight";
  QMouseEvent press(QEvent::MouseButtonPress, where, canvas->mapToGlobal(where.toPoint()), Qt::LeftButton,
                    Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(canvas, &press);
  EXPECT_TRUE(waitFor([&] { return attempt_->view().needle == NeedlePlace::Clean; }));
  finish();
  EXPECT_FALSE(patient.needle().tray());
}

}  // namespace
}  // namespace insonate::train
