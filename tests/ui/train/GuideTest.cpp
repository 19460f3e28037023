#include "AttemptWindow.h"
#include "attempt/AimOverlay.h"
#include "attempt/StandingError.h"
#include "attempt/StepAct.h"

#include <insonate/procedure/Procedure.h>
#include <insonate/ui/Commands.h>

#include <QAction>
#include <QRegularExpression>
#include <QScrollArea>
#include <QToolButton>
#include <algorithm>

namespace insonate::train {
namespace {

/// A guided attempt in a window of a laptop's size.
class TrainGuide : public AttemptWindow {
 protected:
  void begin() {
    workspace_->resize(1366, 700);
    openWide();
    start();
  }
  bool says(const char* words) {
    return waitFor([&] { return text("attemptAct").contains(words); });
  }
  /// Tells whether the mark lies around this control and leaves its clicks to it.
  bool marks(const char* control) {
    auto *mark = child<QWidget>("controlMark"), *target = child<QWidget>(control);
    const QRect place(target->mapTo(workspace_.get(), QPoint()), target->size());
    return waitFor([&] { return mark->isVisible() && mark->geometry().contains(place); }) &&
           workspace_->childAt(place.center()) == target;
  }
  /// Tells whether the mark lies around these controls.
  bool marksAll(std::initializer_list<const char*> controls) {
    auto* mark = child<QWidget>("controlMark");
    QRect all;
    for (const char* name : controls) {
      auto* one = child<QWidget>(name);
      all |= QRect(one->mapTo(workspace_.get(), QPoint()), one->size());
    }
    return mark->isVisible() && mark->geometry().contains(all);
  }
  /// Object names of the visible primary buttons.
  QStringList primaryButtons() {
    QStringList names;
    for (const auto* one : workspace_->findChildren<QPushButton*>())
      if (one->isVisible() && one->property("role").toString() == "primary") names << one->objectName();
    return names;
  }
  /// Tells whether the list of steps shows this label whole.
  bool isInSight(const char* label) {
    auto* one = child<QLabel>(label);
    return !one->isVisible() || one->visibleRegion().boundingRect() == one->rect();
  }
  StepAct actOf(const char* step, const HandsNow& hands, NeedlePlace needle = NeedlePlace::UnderSkin,
                NeedleAim aim = NeedleAim::Unknown) {
    const Procedure& procedure = attempt_->procedure();
    AttemptView view;
    view.needle = needle, view.aim = aim;
    for (std::size_t i = 0; i < procedure.steps.size(); ++i)
      if (procedure.steps[i].name == step) view.nextStep = i;
    EXPECT_TRUE(view.nextStep) << step;
    return nextAct(procedure, view, hands, workspace_->commands());
  }
};

TEST_F(TrainGuide, EachActIsNamedWithItsKeyAndItsControlIsMarked) {
  begin();
  EXPECT_TRUE(says("Choose the position")) << text("attemptAct").toStdString();
  EXPECT_TRUE(marks("attemptPosition"));
  auto* positions = child<QComboBox>("attemptPosition");
  Q_EMIT positions->activated(positions->findText("Trendelenburg 15"));
  model_->imaging.setTilt(15);
  EXPECT_TRUE(says("Compress the tissue with +, then release it with -")) << text("attemptAct").toStdString();
  EXPECT_EQ(actOf("scan", {}).control, "");
  for (int i = 0; i < 8; ++i) key(Qt::Key_Right);
  EXPECT_TRUE(says("Slide the probe")) << "the vein is no longer in the middle";
  for (int i = 0; i < 8; ++i) key(Qt::Key_Left);
  EXPECT_TRUE(says("Compress the tissue with +, then release it with -"));
  EXPECT_TRUE(workspace_->findChild<QWidget*>("indentation")) << "the field that the act marks while it is in sight";
  for (int i = 0; i < 20; ++i) key(Qt::Key_Plus);
  EXPECT_TRUE(says("Release the tissue with -, until the vein is open again.")) << text("attemptAct").toStdString();
  for (int i = 0; i < 20; ++i) key(Qt::Key_Minus);
  EXPECT_TRUE(says("press I, or click the button &quot;in-plane&quot;")) << text("attemptAct").toStdString();
  EXPECT_TRUE(marks("stripAlong"));

  key(Qt::Key_I);
  EXPECT_TRUE(says("steeper: press Alt+W"));
  EXPECT_TRUE(waitFor([&] { return text("attemptNeedle").contains("needle is new, 20° to the skin"); }))
      << text("attemptNeedle").toStdString();
  EXPECT_TRUE(marks("needleSteeper"));
  hands().needleTo({0, 0, 12});
  type("needle_angle", "90");
  EXPECT_TRUE(says("flatter: press Alt+S"));
  type("needle_angle", "58");
  EXPECT_TRUE(
      says("The needle misses the vein. Aim at the vein: slide the entry point (Alt+arrows), or change the heading "
           "(Alt+Q and Alt+E) or the angle (Alt+W and Alt+S, or the highlighted buttons)."))
      << text("attemptAct").toStdString();
  EXPECT_TRUE(waitFor([&] { return marksAll({"needleFlatter", "needleSteeper"}); }));
  hands().needleTo({-7.5, 0, 12});
  EXPECT_TRUE(says("press Page Down")) << text("attemptAct").toStdString();
  EXPECT_TRUE(marks("needleAdvance"));
  hands().needleTo({0, 0, 12});
  type("needle_angle", "90");
  type("needle_depth", "5");
  EXPECT_TRUE(says("Aspirate: press B"));
  EXPECT_TRUE(marks("attemptDraw"));
  key(Qt::Key_B);
  EXPECT_TRUE(says("press Page Down"));
  type("needle_depth", "12");
  EXPECT_TRUE(says("Freeze: press Space"));
  EXPECT_TRUE(marks("freeze"));
  key(Qt::Key_Space);
  EXPECT_TRUE(says("click Unfreeze")) << "a frozen needle cannot be withdrawn";
  key(Qt::Key_Space);
  EXPECT_TRUE(says("press Page Up"));
  EXPECT_TRUE(marks("needleWithdraw"));
  type("needle_depth", "-5");
  EXPECT_TRUE(says("press Ctrl+Return"));
  EXPECT_TRUE(marks("attemptFinish"));
  EXPECT_EQ(primaryButtons(), QStringList("attemptFinish"));
  finish();
  EXPECT_FALSE(shown("controlMark"));
}

TEST_F(TrainGuide, OnlyTheButtonOfTheDueActIsPrimary) {
  workspace_->resize(1366, 700);
  openWide();
  EXPECT_EQ(primaryButtons(), QStringList("attemptStart"));
  start();
  ASSERT_TRUE(says("Choose the position"));
  EXPECT_EQ(primaryButtons(), QStringList()) << "the position is chosen in a list";
  model_->imaging.setTilt(15);
  ASSERT_TRUE(says("Compress the tissue"));
  for (int i = 0; i < 20; ++i) key(Qt::Key_Plus);
  ASSERT_TRUE(says("Release the tissue"));
  for (int i = 0; i < 20; ++i) key(Qt::Key_Minus);
  ASSERT_TRUE(says("press I"));
  EXPECT_EQ(primaryButtons(), QStringList("stripAlong"));
  key(Qt::Key_I);
  ASSERT_TRUE(says("steeper: press Alt+W"));
  EXPECT_EQ(primaryButtons(), QStringList("needleSteeper"));
  finish();
  EXPECT_EQ(primaryButtons(), QStringList("attemptReview"));
}

TEST_F(TrainGuide, ALaptopShowsAllStepsAtOnce) {
  begin();
  model_->imaging.setTilt(15);
  const auto areAllInSight = [&] {
    return isInSight("attemptStepsDone") && isInSight("attemptDue") && isInSight("attemptAct") &&
           isInSight("attemptStepsLater");
  };
  ASSERT_TRUE(says("Compress the tissue"));
  EXPECT_TRUE(waitFor(areAllInSight));
  for (int i = 0; i < 20; ++i) key(Qt::Key_Plus);
  ASSERT_TRUE(says("Release the tissue"));
  for (int i = 0; i < 20; ++i) key(Qt::Key_Minus);
  ASSERT_TRUE(says("press I"));
  EXPECT_TRUE(waitFor(areAllInSight));
  key(Qt::Key_I);
  hands().needleTo({0, 0, 12});
  type("needle_angle", "58");
  ASSERT_TRUE(says("or the highlighted buttons")) << "the longest act";
  EXPECT_TRUE(waitFor(areAllInSight));
}

TEST_F(TrainGuide, ALowWindowShowsTheDueStepAndItsNeighbors) {
  workspace_->resize(1100, 520);
  openWide();
  start();
  model_->imaging.setTilt(15);
  ASSERT_TRUE(says("Compress the tissue"));
  auto* inSight = child<QScrollArea>("attemptMessages");
  const auto isWhole = [&](const char* label) {
    auto* one = child<QLabel>(label);
    return inSight->viewport()->rect().contains(QRect(one->mapTo(inSight->viewport(), QPoint()), one->size()));
  };
  EXPECT_TRUE(waitFor([&] { return isWhole("attemptDue") && isWhole("attemptAct"); }));
  const auto rowOf = [&](const char* label, bool isLast) {
    auto* one = child<QLabel>(label);
    return one->mapTo(inSight->viewport(), QPoint(0, isLast ? one->height() - 1 : 0)).y();
  };
  EXPECT_GE(rowOf("attemptStepsDone", true), 10) << "a line before it";
  EXPECT_LE(rowOf("attemptStepsLater", false), inSight->viewport()->height() - 10) << "a line after it";
}

TEST_F(TrainGuide, HintsAndTestsNameAndMarkNothing) {
  for (const Assistance one : {Assistance::Hints, Assistance::Test}) {
    attempt_->setAssistance(one);
    begin();
    QTest::qWait(300);
    EXPECT_FALSE(shown("attemptAct"));
    EXPECT_FALSE(shown("controlMark"));
    EXPECT_EQ(primaryButtons(), QStringList());
    finish();
    attempt_->leave();
  }
}

TEST_F(TrainGuide, DevicesAreNamedOnlyIfTheyAreInUse) {
  openWide();
  HandsNow byKeys;
  byKeys.hasNeedle = true;
  HandsNow byDevice = byKeys;
  byDevice.isNeedleInDevice = byDevice.isProbeInDevice = byDevice.hasPedal = true;
  EXPECT_FALSE(actOf("inspect", byKeys).words.contains("pedal"));
  EXPECT_TRUE(actOf("inspect", byDevice).words.contains("pedal"));
  EXPECT_TRUE(actOf("withdraw", byKeys).words.contains("Page Up"));
  EXPECT_EQ(actOf("withdraw", byDevice).words, "Withdraw the needle with the device that controls it.");
  EXPECT_TRUE(actOf("scan", byKeys).words.contains("with the arrows"));
  EXPECT_EQ(actOf("scan", byDevice).words, "Slide the probe with the device that controls it.");
  EXPECT_TRUE(actOf("confirm", byDevice).words.contains("second button"));
  EXPECT_FALSE(actOf("confirm", byKeys).words.contains("second button"));
  byDevice.hasNeedle = false;
  EXPECT_EQ(actOf("skin", byDevice, NeedlePlace::Clean).control, "showDevices") << "it is not connected";
}

TEST_F(TrainGuide, AWireThatMeetsAResistanceIsNotPushedOn) {
  openWide();
  const auto procedure = loadProcedure("internal_jugular_line");
  ASSERT_TRUE(procedure) << procedure.error().message;
  HandsNow now;
  now.hasNeedle = true;
  AttemptView view;
  view.nextStep =
      std::size_t(std::ranges::find(procedure->steps, "wire", &ProcedureStep::name) - procedure->steps.begin());
  const auto act = [&] { return nextAct(*procedure, view, now, workspace_->commands()); };
  view.needle = NeedlePlace::Vein, view.line.isNeedleInBody = true, view.line.isSyringeOn = false;
  EXPECT_EQ(act().control, "lineAdvance");
  view.line.wire_mm = view.line.wireStop_mm = 60;
  EXPECT_EQ(act().control, "lineWithdraw");
  EXPECT_TRUE(act().words.startsWith("The wire meets a resistance")) << act().words.toStdString();
  view.line.isWireKinked = true;
  EXPECT_EQ(act().control, "lineWithdraw") << "the whole wire";
  view.line = {};
  now.hasNeedle = false, view.needle = NeedlePlace::Clean;
  EXPECT_EQ(act().control, "stripAlong") << "without a needle, the wire has no way into the body";
  view.nextStep = *view.nextStep + 3;
  EXPECT_EQ(act().words,
            "Show the wire in long axis: rotate the probe with Q and E, and slide it with the arrows, until a bright "
            "line of at least 10 mm lies in the vein.");
}

TEST_F(TrainGuide, AfterAWrongPlaceTheNeedleIsWithdrawnAndReplaced) {
  openWide();
  HandsNow now;
  now.hasNeedle = true;
  EXPECT_EQ(actOf("vein", now, NeedlePlace::WrongPlace).control, "needleWithdraw");
  EXPECT_EQ(actOf("confirm", now, NeedlePlace::WrongPlace).control, "needleWithdraw");
  EXPECT_EQ(actOf("inspect", now, NeedlePlace::WrongPlace).control, "needleWithdraw") << "blood was drawn before";
  EXPECT_EQ(actOf("skin", now, NeedlePlace::Used).control, "attemptNewNeedle");
  now.plane = NeedlePlane::OutOfPlane, now.hasNeedle = false;
  EXPECT_EQ(actOf("skin", now, NeedlePlace::Clean).control, "stripAcross");
}

/// Otherwise the guide, followed to the letter, misses the standard of the tip in the image.
TEST_F(TrainGuide, OutOfPlaneTheProbeFollowsTheTip) {
  openWide();
  HandsNow now;
  now.hasNeedle = now.isAspirating = true;
  now.plane = NeedlePlane::OutOfPlane;
  const StepAct act = actOf("vein", now);
  EXPECT_EQ(act.control, "needleAdvance");
  EXPECT_TRUE(act.words.contains("slide the probe with the arrows until the tip is visible again"))
      << act.words.toStdString();
  now.plane = NeedlePlane::InPlane;
  EXPECT_FALSE(actOf("vein", now).words.contains("slide"));
}

TEST_F(TrainGuide, ANeedleThatMissesTheVeinIsAimedOrWithdrawn) {
  openWide();
  HandsNow now;
  now.hasNeedle = true;
  const auto under = [&](NeedleAim aim) { return actOf("vein", now, NeedlePlace::UnderSkin, aim); };
  EXPECT_EQ(under(NeedleAim::Beside).control, "needleWithdraw") << "the tissue holds it";
  now.canTurnNeedle = true;
  EXPECT_EQ(
      under(NeedleAim::Artery).words,
      "The needle points at the artery. Aim at the vein: change the heading (Alt+Q and Alt+E) or the angle (Alt+W "
      "and Alt+S, or the highlighted buttons).");
  EXPECT_EQ(under(NeedleAim::Beside).control, "needleAngleButtons");
  EXPECT_EQ(under(NeedleAim::Vein).control, "attemptDraw");
  now.isNeedleInDevice = true;
  EXPECT_EQ(under(NeedleAim::Beside).words,
            "The needle misses the vein. Withdraw the needle to the skin with the device that controls it, and aim at "
            "the vein.");
}

TEST_F(TrainGuide, TheAimIsALineInPlaneAndACrossOutOfPlane) {
  openWide();
  const ImagingSetup& setup = *model_->live.shown()->setup;
  const Transform probe;  // its frame is that of the patient
  Needle needle;
  needle.tip_mm = {-5, 0, 10}, needle.direction = {0.6, 0, 0.8};
  const views::NeedlePathOverlay inPlane = aimOf(needle, probe, setup);
  ASSERT_EQ(inPlane.line.size(), 2U);
  EXPECT_EQ(inPlane.line[0], (views::ImagePoint{-5, 10}));
  EXPECT_NEAR((inPlane.line[1].axial_mm - 10) / (inPlane.line[1].lateral_mm + 5), 0.8 / 0.6, 1e-9);
  EXPECT_TRUE(inPlane.tip);
  EXPECT_FALSE(inPlane.cross);
  for (const double beside_mm : {6.0, -6.0}) {
    needle.tip_mm.y = beside_mm;
    EXPECT_EQ(aimOf(needle, probe, setup), views::NeedlePathOverlay())
        << "it would aim at a vessel that the needle passes";
  }

  needle.tip_mm = {2, -12, 4}, needle.direction = {0, 0.8, 0.6};
  const views::NeedlePathOverlay before = aimOf(needle, probe, setup);
  EXPECT_TRUE(before.line.empty());
  EXPECT_FALSE(before.tip) << "12 mm beside the slice";
  ASSERT_TRUE(before.cross);
  EXPECT_NEAR(before.cross->lateral_mm, 2, 1e-9);
  EXPECT_NEAR(before.cross->axial_mm, 4 + 12 * 0.6 / 0.8, 1e-9);
  needle.tip_mm.y = 12;
  EXPECT_FALSE(aimOf(needle, probe, setup).cross) << "it has crossed the slice";
}

TEST_F(TrainGuide, TheAimIsShownWhileGuidedUnlessItIsSwitchedOff) {
  begin();
  const views::UltrasoundView& image =
      static_cast<const views::UltrasoundView&>(child<ui::ViewWidget>("ultrasoundView")->view());
  const auto isShown = [&] { return image.aim().line.size() == 2; };
  key(Qt::Key_I);
  EXPECT_TRUE(waitFor(isShown));
  auto* box = child<QCheckBox>("attemptAim");
  EXPECT_TRUE(box->isVisible() && box->isChecked());
  key(Qt::Key_G, Qt::ControlModifier);
  EXPECT_FALSE(isShown());
  EXPECT_FALSE(box->isChecked());
  box->click();
  EXPECT_TRUE(isShown());
  finish();
  EXPECT_FALSE(isShown()) << "after the attempt";
  attempt_->setAssistance(Assistance::Test);
  attempt_->leave();
  start();
  key(Qt::Key_I);
  QTest::qWait(300);
  EXPECT_FALSE(isShown());
  EXPECT_FALSE(shown("attemptAim"));
}

TEST(TrainStandingError, IsTheWorstOneThatIsNotDealtWith) {
  Procedure procedure;
  procedure.rules.resize(3);
  procedure.rules[0].severity = Severity::Minor;
  procedure.rules[1].severity = Severity::Major;
  procedure.rules[2].severity = Severity::Critical;
  AttemptView view;
  StandingError standing;
  const auto found = [&] { return standing.find(procedure, view); };
  view.findings = {{.rule = 0, .time_us = 10}};
  EXPECT_FALSE(found()) << "a minor one";
  view.findings.push_back({.rule = 2, .time_us = 20});
  view.findings.push_back({.rule = 1, .time_us = 30});
  for (int i = 0; i < 5; ++i) view.findings.push_back({.rule = 0, .time_us = 40});
  EXPECT_EQ(found(), 1U) << "critical before major, however many minor ones follow";
  standing.dismiss(1);
  EXPECT_EQ(found(), 2U);
  view.events.push_back({.time_us = 25, .kind = AttemptEventKind::Withdrawn, .wall = kSkin});
  EXPECT_EQ(found(), 2U) << "withdrawn before it";
  view.events.push_back({.time_us = 35, .kind = AttemptEventKind::Withdrawn, .wall = kVein});
  EXPECT_EQ(found(), 2U) << "still under the skin";
  view.events.push_back({.time_us = 45, .kind = AttemptEventKind::Withdrawn, .wall = kSkin});
  EXPECT_FALSE(found());
  standing.reset();
  EXPECT_FALSE(found()) << "withdrawn after both";
}

TEST_F(TrainGuide, ASevereErrorStaysUntilItIsDealtWith) {
  begin();
  overTheVein();
  type("needle_depth", "22");
  ASSERT_TRUE(waitFor([&] { return shown("attemptStanding"); }));
  EXPECT_TRUE(text("attemptStanding").contains("through the posterior wall"));
  EXPECT_FALSE(text("attemptFindings").contains("through the posterior wall")) << "once";
  auto* label = child<QLabel>("attemptStanding");
  EXPECT_TRUE(waitFor([&] { return label->height() >= label->heightForWidth(label->width()); })) << "cut";
  key(Qt::Key_Backspace);
  EXPECT_FALSE(shown("attemptStanding"));
  EXPECT_TRUE(text("attemptFindings").contains("through the posterior wall"));
  type("needle_depth", "-5");
  ASSERT_TRUE(waitFor([&] { return attempt_->view().needle == NeedlePlace::Used; }));
  type("needle_depth", "5");
  ASSERT_TRUE(waitFor([&] { return text("attemptStanding").contains("in the skin before"); }));
  EXPECT_TRUE(shown("attemptStanding"));
  child<QToolButton>("attemptDismiss")->click();
  EXPECT_FALSE(shown("attemptStanding"));
  type("needle_depth", "-5");
  ASSERT_TRUE(waitFor([&] { return attempt_->view().needle == NeedlePlace::Used; }));
  type("needle_depth", "5");
  ASSERT_TRUE(waitFor([&] { return shown("attemptStanding"); })) << "another one";
  type("needle_depth", "-5");
  EXPECT_TRUE(waitFor([&] { return !shown("attemptStanding"); })) << "the needle is out of the skin";
}

TEST_F(TrainGuide, PuttingTheNeedleDownReleasesThePlunger) {
  begin();
  overTheVein();
  key(Qt::Key_B);
  ASSERT_TRUE(attempt_->isAspirating());
  key(Qt::Key_I);
  ASSERT_FALSE(hands().needleHand());
  EXPECT_FALSE(attempt_->isAspirating());
  EXPECT_FALSE(child<QPushButton>("attemptDraw")->isChecked());
}

TEST_F(TrainGuide, TheStripIsWholeOnALaptop) {
  begin();
  overTheVein();
  QTest::qWait(300);
  const int image_px = child<QWidget>("ultrasoundView")->height();
  type("needle_depth", "12");
  ASSERT_TRUE(waitFor([&] { return attempt_->view().needle == NeedlePlace::Vein; }));
  key(Qt::Key_B);
  ASSERT_TRUE(waitFor([&] { return text("attemptDrawn").contains("dark red"); }));
  QTest::qWait(300);
  EXPECT_EQ(child<QWidget>("ultrasoundView")->height(), image_px) << "longer words do not change the image's scale";
  EXPECT_GE(child<QWidget>("attemptNeedle")->y(), child<QWidget>("attemptTime")->geometry().bottom()) << "a second row";
  for (const char* name : {"attemptTime", "attemptVein", "attemptArtery", "attemptDouble", "attemptToVein",
                           "attemptUsed", "attemptNeedle", "attemptDrawn", "syringe"}) {
    auto* one = child<QWidget>(name);
    EXPECT_TRUE(one->isVisible()) << name;
    EXPECT_EQ(one->visibleRegion().boundingRect(), one->rect()) << name << " is cut";
    if (auto* label = qobject_cast<QLabel*>(one)) {
      const bool isWrapped = label->wordWrap();
      EXPECT_TRUE(isWrapped || label->width() >= label->sizeHint().width()) << name;
      EXPECT_TRUE(!isWrapped || label->height() >= label->heightForWidth(label->width())) << name;
    }
  }
}

TEST_F(TrainGuide, NamesOfStructuresAreOverTheImageButNotInATest) {
  openWide();
  const auto& image = static_cast<const views::UltrasoundView&>(child<ui::ViewWidget>("ultrasoundView")->view());
  EXPECT_TRUE(image.names().empty());
  QAction* action = workspace_->commands().action("train.image.names");
  key(Qt::Key_N, Qt::ControlModifier);
  EXPECT_TRUE(action->isChecked());
  const auto vein = [&] { return std::ranges::find(image.names(), "vein", &views::NameOverlay::words); };
  ASSERT_TRUE(waitFor([&] { return vein() != image.names().end(); }));
  EXPECT_NEAR(vein()->at.lateral_mm, 0, 1.5);
  EXPECT_NEAR(vein()->at.axial_mm, 12, 1.5);
  attempt_->setAssistance(Assistance::Test);
  start();
  EXPECT_TRUE(image.names().empty());
  EXPECT_FALSE(action->isEnabled());
  finish();
  EXPECT_TRUE(waitFor([&] { return !image.names().empty(); })) << "they return";
}

TEST(TrainGuideTexts, OfProceduresNameNoKeysAndNoDevices) {
  const QRegularExpression input("\\b(press|pedal|space|key|click|button)\\b",
                                 QRegularExpression::CaseInsensitiveOption);
  for (const std::string& name : procedurePresetNames()) {
    const auto procedure = loadProcedure(name);
    ASSERT_TRUE(procedure);
    for (const ProcedureStep& step : procedure->steps)
      EXPECT_FALSE(input.match(QString::fromStdString(step.instruction)).hasMatch()) << step.instruction;
  }
}

}  // namespace
}  // namespace insonate::train
