#include "TrainWindow.h"
#include "layout/NumberField.h"

#include <QLineEdit>
#include <QToolTip>

namespace insonate::train {
namespace {

/// Typed numbers of the probe, in the window.
class ProbeNumbersTyped : public TrainWindow {
 protected:
  void type(const char* field, const QString& text, Qt::Key end = Qt::Key_Return) {
    QLineEdit* line = child<NumberField>(field);
    line->selectAll();
    QTest::keyClicks(line, text);
    QTest::keyClick(line, end);
  }
  QString text(const char* field) { return child<NumberField>(field)->text(); }
};

TEST_F(ProbeNumbersTyped, EnterApplies) {
  openCase();
  type("tilt", "12.5");
  EXPECT_NEAR(model_->motion.numbers().tilt_deg, 12.5, 1e-6);
  EXPECT_EQ(text("tilt").toStdString(), "12.5°");
  type("rock", "-3,5 °");
  EXPECT_NEAR(model_->motion.numbers().rock_deg, -3.5, 1e-6) << "with a comma and the unit";
  type("x", "6");
  EXPECT_NEAR(model_->motion.numbers().skin_mm.x, 6, 0.2);
  EXPECT_NEAR(model_->motion.numbers().tilt_deg, 12.5, 1e-6) << "angles stay";
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_NEAR(model_->motion.numbers().skin_mm.x, 0, 0.2);
}

TEST_F(ProbeNumbersTyped, WhatIsWrongIsSaidAndChangesNothing) {
  openCase();
  const ProbePlacementState start = model_->motion.state();
  type("tilt", "steep");
  EXPECT_TRUE(workspace_->statusText().contains("tilt takes a number from -60.0° to 60.0°"))
      << workspace_->statusText().toStdString();
  type("tilt", "75");
  EXPECT_TRUE(workspace_->statusText().contains("must be from -60.0° to 60.0°; 75 is outside this range"))
      << workspace_->statusText().toStdString();
  EXPECT_EQ(QToolTip::text(), workspace_->statusText()) << "under the field, too";
  EXPECT_EQ(text("tilt").toStdString(), "0.0°");
  EXPECT_EQ(model_->motion.state(), start);
  type("tilt", "30", Qt::Key_Escape);
  EXPECT_EQ(model_->motion.state(), start);
}

TEST_F(ProbeNumbersTyped, APlaceInTheAirGoesToTheNearestSkinAndSaysSo) {
  openCase();
  type("y", "-6");
  EXPECT_NEAR(model_->motion.numbers().skin_mm.y, 0, 1);
  EXPECT_TRUE(workspace_->statusText().contains("nearest skin")) << workspace_->statusText().toStdString();
}

TEST_F(ProbeNumbersTyped, ArrowsStep) {
  openCase();
  QTest::keyClick(child<NumberField>("tilt"), Qt::Key_Up);
  EXPECT_NEAR(model_->motion.numbers().tilt_deg, 1, 1e-6);
  const double press_mm = model_->motion.numbers().press_mm;
  QTest::keyClick(child<NumberField>("indentation"), Qt::Key_Up);
  EXPECT_NEAR(model_->motion.numbers().press_mm, press_mm + 0.5, 1e-6);
}

}  // namespace
}  // namespace insonate::train
