#include <insonate/ui/ValueSlider.h>

#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QShortcut>
#include <QSignalSpy>
#include <QSlider>
#include <QToolTip>
#include <QWheelEvent>
#include <QtTest/QTest>
#include <cmath>

namespace {

class ValueSlider : public testing::Test {
 protected:
  ValueSlider() : slider("Depth", "mm", {20, 90, 40, 5, 1}, "How deep the picture reaches") {
    slider.resize(240, 48);
    slider.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&slider));
  }

  QLineEdit* number() { return slider.findChild<QLineEdit*>(); }
  QSlider* track() { return slider.findChild<QSlider*>(); }

  void type(const QString& text) {
    number()->setFocus();
    number()->selectAll();
    QTest::keyClicks(number(), text);
    QTest::keyClick(number(), Qt::Key_Return);
  }
  void wheel(int eighths) {
    QWheelEvent event(QPointF(10, 5), track()->mapToGlobal(QPoint(10, 5)), {}, {0, eighths}, Qt::NoButton,
                      Qt::ControlModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(track(), &event);
  }

  insonate::ui::ValueSlider slider;
};

TEST_F(ValueSlider, ShowsNameValueAndUnit) {
  EXPECT_EQ(slider.value(), 40);
  EXPECT_EQ(number()->text(), "40.0 mm");
  EXPECT_EQ(slider.findChild<QLabel*>()->text(), "Depth");
  EXPECT_EQ(number()->accessibleName(), "Depth in mm");
  EXPECT_TRUE(slider.toolTip().contains("20.0 mm to 90.0 mm"));
}

TEST_F(ValueSlider, NumberAndUnitAreReadWholeInHalfAColumn) {
  constexpr int kHalf_px = 130;
  insonate::ui::ValueSlider half("on slices", "%", {0, 100, 100, 5, 0});
  EXPECT_LE(half.minimumSizeHint().width(), kHalf_px);
  half.resize(kHalf_px, 48);
  half.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&half));
  const auto* text = half.findChild<QLineEdit*>();
  ASSERT_EQ(text->text(), "100 %");
  constexpr int kFrame_px = 14;  // what the line takes of its width on both sides
  EXPECT_GE(text->width() - kFrame_px, text->fontMetrics().horizontalAdvance(text->text()));
  EXPECT_LE(text->geometry().right(), half.width());
}

/// Enter means "apply" in the window around it.
TEST(ValueSliderInAWindow, EnterEndsTheNumberAndNothingElse) {
  struct Surroundings : QWidget {
    int keys = 0;
    void keyPressEvent(QKeyEvent*) override { ++keys; }
  } window;
  auto* slider = new insonate::ui::ValueSlider("size", "mm", {0, 20, 0, 1, 1}, {}, &window);
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  auto* number = slider->findChild<QLineEdit*>();
  number->setFocus();
  for (const auto enter : {Qt::Key_Return, Qt::Key_Enter}) {
    number->selectAll();
    QTest::keyClicks(number, "3");
    QTest::keyClick(number, enter);
    EXPECT_EQ(slider->value(), 3);
    EXPECT_EQ(number->selectedText(), "3.0 mm") << "the next number takes its place";
    slider->setValue(1);
  }
  EXPECT_EQ(window.keys, 0);
}

TEST(ValueSliderInAWindow, TakingBackIsTheWindowsOnceTheNumberIsTaken) {
  QWidget window;
  auto* slider = new insonate::ui::ValueSlider("size", "mm", {0, 20, 0, 1, 1}, {}, &window);
  QShortcut undo(QKeySequence::Undo, &window);
  QSignalSpy taken(&undo, &QShortcut::activated);
  window.show();
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  auto* number = slider->findChild<QLineEdit*>();
  number->setFocus();
  number->selectAll();
  QTest::keyClicks(number, "3");
  QTest::keyClick(number, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(taken.count(), 0) << "of what is being typed";
  QTest::keyClick(number, Qt::Key_Return);
  QTest::keyClick(number, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(taken.count(), 1);
}

TEST_F(ValueSlider, TakesTypedNumbers) {
  QSignalSpy changes(&slider, &insonate::ui::ValueSlider::valueChanged);
  type("52.5");
  EXPECT_EQ(slider.value(), 52.5);
  type("33,25 mm");
  EXPECT_NEAR(slider.value(), 33.3, 0.051);
  ASSERT_EQ(changes.count(), 2);
  EXPECT_EQ(changes[0][0].toDouble(), 52.5);
}

TEST_F(ValueSlider, KeepsTypedNumbersWithinTheRangeAndForgetsNonsense) {
  type("500");
  EXPECT_EQ(slider.value(), 90);
  EXPECT_EQ(QToolTip::text(), "Depth must be from 20.0 mm to 90.0 mm; 500 is outside this range.");
  type("-3");
  EXPECT_EQ(slider.value(), 20);
  type("deep");
  EXPECT_EQ(slider.value(), 20);
  EXPECT_EQ(QToolTip::text(), "Depth takes a number from 20.0 mm to 90.0 mm; \"deep\" is not a number.");
  EXPECT_EQ(number()->text(), "20.0 mm");
  slider.setValue(std::nan(""));
  EXPECT_EQ(slider.value(), 20);
}

TEST_F(ValueSlider, StepsByWheelAndArrows) {
  wheel(120);
  EXPECT_EQ(slider.value(), 45);
  wheel(-240);
  EXPECT_EQ(slider.value(), 35);
  wheel(60);
  EXPECT_EQ(slider.value(), 35) << "half a notch of a touch pad";
  wheel(60);
  EXPECT_EQ(slider.value(), 40);
  QTest::keyClick(track(), Qt::Key_Right);
  QTest::keyClick(track(), Qt::Key_Up);
  EXPECT_EQ(slider.value(), 50);
  QTest::keyClick(track(), Qt::Key_Left);
  EXPECT_EQ(slider.value(), 45);
  QTest::keyClick(number(), Qt::Key_Down);
  EXPECT_EQ(slider.value(), 40);
}

TEST_F(ValueSlider, DoubleClickOnTrackOrNameGivesTheUsualValueBack) {
  slider.setValue(77);
  QTest::mouseDClick(track(), Qt::LeftButton, {}, {5, 5});
  EXPECT_EQ(slider.value(), 40);
  slider.setValue(77);
  QTest::mouseDClick(slider.findChild<QLabel*>(), Qt::LeftButton);
  EXPECT_EQ(slider.value(), 40);
}

TEST_F(ValueSlider, ComesToWhereTheTrackIsPressed) {
  QTest::mouseClick(track(), Qt::LeftButton, {}, {track()->width() - 3, track()->height() / 2});
  EXPECT_EQ(slider.value(), 90);
}

TEST_F(ValueSlider, NewRangesKeepTheValueInside) {
  slider.setRange({50, 60, 55, 1, 0});
  EXPECT_EQ(slider.value(), 50);
  EXPECT_EQ(number()->text(), "50 mm");
}

}  // namespace
