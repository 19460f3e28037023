#include "HelpWindow.h"
#include "attempt/AttemptControl.h"
#include "model/TrainModel.h"

#include <insonate/cases/Phantom.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/CurriculumStore.h>
#include <insonate/simulator/ScriptedSession.h>
#include <insonate/teaching/DemoClass.h>
#include <insonate/ui/Account.h>
#include <insonate/ui/ViewWidget.h>

#include <unit/curriculum/StoreRig.h>

#include <QComboBox>
#include <QDateTime>
#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QTableView>

namespace insonate::test {
namespace {

constexpr QSize kLarge{1600, 1000}, kLaptop{1366, 768};

/// The attempts and the classes of the help's first steps.
class HelpImages : public HelpWindow {
 protected:
  /// Returns the smallest part of the window that shows these widgets.
  QRect span(std::initializer_list<const char*> names) {
    QRect part;
    for (const char* name : names) part |= rectOf(*child<QWidget>(name), *window_);
    return part & window_->rect();
  }
  train::AttemptControl& attempt() { return *window_->findChild<train::AttemptControl*>(); }

  /// Starts a guided attempt in free practice, which starts at the case's own start position: a level starts at a
  /// random one.
  void start() {
    open("train", kLaptop);
    key(Qt::Key_Return, Qt::ControlModifier);
    ASSERT_TRUE(waitFor([&] { return attempt().isRunning(); })) << window_->statusText().toStdString();
    auto* position = child<QComboBox>("attemptPosition");
    position->setCurrentIndex(position->findText("Trendelenburg 15"));
    Q_EMIT position->activated(position->currentIndex());
    ASSERT_TRUE(waitFor([&] { return attempt().view().isVeinCentered; }));
  }
  /// Presses a key up to 60 times until this is so; each time waits for the image and for the state of the attempt,
  /// which follows the image within 0.1 s. Returns the number of presses.
  int pressUntil(Qt::Key by, const std::function<bool()>& until, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    auto& model = *window_->findChild<train::TrainModel*>();
    int presses = 0;
    for (; presses < 60 && !until(); ++presses) {
      key(by, modifiers);
      EXPECT_TRUE(waitFor([&] { return model.live.shown()->patientFromProbe == model.motion.pose(); }));
      QTest::qWait(250);
    }
    return presses;
  }
  /// Compresses the tissue until the vein is compressed, and releases it until the step is done and further.
  void compress() {
    const auto step = attempt().view().nextStep;
    const int presses = pressUntil(Qt::Key_Plus, [&] { return attempt().view().isVeinCompressed; });
    const int released = pressUntil(Qt::Key_Minus, [&] { return attempt().view().nextStep != step; });
    for (int i = released; i < presses; ++i) key(Qt::Key_Minus);
    ASSERT_NE(attempt().view().nextStep, step);
  }
  /// Turns the needle to 45 degrees, and slides the point where it enters the skin until its line meets the vein.
  void aim() {
    key(Qt::Key_I);
    const auto& hands = window_->findChild<train::TrainModel*>()->hands;
    for (int i = 0; i < 60 && hands.needleHand()->state().angle_deg < 45; ++i) key(Qt::Key_W, Qt::AltModifier);
    const auto aimed = [&] { return attempt().view().aim == NeedleAim::Vein; };
    pressUntil(Qt::Key_Left, aimed, Qt::AltModifier);
    ASSERT_TRUE(aimed());
    for (int i = 0; i < 3; ++i) key(Qt::Key_Left, Qt::AltModifier);  // from the edge of the vein to its middle
  }
  /// Advances the needle by half millimeters until blood is in the syringe.
  void puncture() {
    const auto inVein = [&] { return attempt().view().needle == NeedlePlace::Vein; };
    key(Qt::Key_B);
    pressUntil(Qt::Key_PageDown, inVein);
    ASSERT_TRUE(waitFor(inVein));
    QTest::qWait(1500);
  }
};

TEST_F(HelpImages, TrainOnTheTextbookNeck) {
  open("train", kLarge);
  expectCurrent(*window_, window_->rect(), "window");
}

TEST_F(HelpImages, TheFirstLine) {
  start();
  settle();
  ASSERT_TRUE(waitFor([&] { return child<QLabel>("attemptAct")->text().contains("Compress"); }));
  expectCurrent(*window_, span({"attemptPanel", "ultrasoundView"}), "first-find");
  compress();
  aim();
  puncture();
  settle();
  expectCurrent(*window_, span({"attemptPanel", "ultrasoundView"}), "first-aim");
  key(Qt::Key_Return, Qt::ControlModifier);
  ASSERT_TRUE(waitFor([&] { return attempt().state() == train::AttemptControl::State::Over; }));
  settle();
  expectCurrent(*window_, span({"attemptPanel"}), "first-result");
}

TEST_F(HelpImages, PrepareOnTheTextbookNeck) {
  open("prepare", kLarge);
  expectCurrent(*window_, window_->rect(), "prepare");
  window_->resize(kLaptop);
  settle();
  expectCurrent(*window_, QRect(0, 0, 900, 560), "first-case");
}

TEST_F(HelpImages, AnAttemptInReview) {
  const PatientCase neck = valueOf(makePhantom("textbook", 1));
  const auto script = valueOf(loadSessionScript("posterior-wall", neck));
  const QString file = home_.filePath("posterior-wall.attempt");
  ASSERT_TRUE(runSession(script, neck, "insonate", file.toStdString()));
  open("review", kLarge);
  window_->openAttempt(file);
  settle();
  expectCurrent(*window_, window_->rect(), "review");
}

TEST_F(HelpImages, AClassInReview) {
  {
    const std::int64_t now_us = QDateTime::currentMSecsSinceEpoch() * 1000;
    const auto store = valueOf(CurriculumStore::open(home_.filePath("people.sqlite").toStdString(),
                                                     StoreServices{.passwordCost = PasswordCost::Minimum}));
    const Curriculum curriculum = valueOf(loadCurriculum("central_line"));
    succeed(makeDemoClass(store, curriculum, {.trainees = 12, .attempts = 14, .until_us = now_us}, kPassword));
  }
  open("review", kLarge);
  std::optional<Result<void>> done;
  window_->account().signIn(kDemoInstructor, QString::fromStdString(kPassword),
                            [&](const Result<void>& result) { done = result; });
  ASSERT_TRUE(waitFor([&] { return done.has_value(); }));
  test::succeed(*done);
  ASSERT_TRUE(waitFor([&] { return child<QTableView>("classTable")->model()->rowCount() == 12; }));
  settle();
  expectCurrent(*window_, window_->rect(), "class");
  window_->resize(kLaptop);
  settle();
  expectCurrent(*window_, span({"classTable"}), "first-class");
  child<QTableView>("classTable")->setFocus();
  QTest::keyClick(child<QTableView>("classTable"), Qt::Key_T, Qt::AltModifier);
  ASSERT_TRUE(waitFor([&] { return window_->findChild<QDialog*>("openingDialog") != nullptr; }));
  auto* dialog = child<QDialog>("openingDialog");
  ASSERT_TRUE(waitFor([&] { return dialog->isVisible(); }));
  QTest::qWait(500);
  expectCurrent(*dialog, dialog->rect(), "first-test");
}

}  // namespace
}  // namespace insonate::test
