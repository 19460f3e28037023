#include "NeedleWindow.h"

#include <QLabel>
#include <QScrollArea>
#include <QWheelEvent>

namespace insonate::train {
namespace {

/// The needle of mouse and keys: from the keyboard to what it meets.
class TrainNeedle : public NeedleWindow {};

TEST_F(TrainNeedle, KeysTakeItUpAimItAndLayItDown) {
  openWide();
  EXPECT_FALSE(child<QLineEdit>("needle_depth")->isVisible());
  key(Qt::Key_PageDown);
  EXPECT_TRUE(workspace_->statusText().contains("(I)")) << workspace_->statusText().toStdString();
  key(Qt::Key_I);
  ASSERT_TRUE(hands().needleHand());
  EXPECT_TRUE(child<QPushButton>("needleAlong")->isChecked());
  EXPECT_TRUE(child<QLineEdit>("needle_depth")->isVisible());
  const NeedlePlacementState before = held();
  EXPECT_NEAR(before.entry_mm.x, -26, 0.5) << "beside the end of the probe";
  key(Qt::Key_W, Qt::AltModifier);
  EXPECT_NEAR(held().angle_deg, before.angle_deg + 1, 1e-9);
  EXPECT_TRUE(child<QLineEdit>("needle_angle")->text().startsWith(QString::number(before.angle_deg + 1, 'f', 1)));
  key(Qt::Key_Right, Qt::AltModifier);
  EXPECT_NEAR(held().entry_mm.x, before.entry_mm.x + 1, 0.1);
  key(Qt::Key_D, Qt::AltModifier);
  EXPECT_NEAR(held().bevel_deg, 10, 1e-9);
  const double heading_deg = hands().needleHand()->heading_deg();
  key(Qt::Key_E, Qt::AltModifier | Qt::ShiftModifier);
  EXPECT_NEAR(hands().needleHand()->heading_deg(), heading_deg + 10, 0.5);
  EXPECT_EQ(model_->motion.numbers().rotation_deg, 0) << "the probe stays";
  child<QPushButton>("needleAcross")->click();
  EXPECT_EQ(held().angle_deg, NeedlePlacement::kInitialAngle_deg);
  key(Qt::Key_I);
  EXPECT_FALSE(hands().needleHand());
  EXPECT_FALSE(child<QLineEdit>("needle_depth")->isVisible());
}

TEST_F(TrainNeedle, PushedInItSaysOnceWhatItEntersAndLeaves) {
  openWide();
  overTheVein();
  type("needle_depth", "12");
  ASSERT_TRUE(waitFor([&] { return lying().in == kVein; })) << workspace_->statusText().toStdString();
  EXPECT_TRUE(waitFor([&] { return heard("Vein entered") == 1; }));
  EXPECT_EQ(heard("The needle is through the skin"), 1);
  EXPECT_TRUE(waitFor([&] { return child<QLabel>("needleWords")->text().startsWith("in vein, inserted 1"); }));
  type("needle_depth", "22");
  EXPECT_TRUE(waitFor([&] { return heard("posterior wall of the vein") == 1; }));
  type("needle_depth", "-5");
  EXPECT_TRUE(waitFor([&] { return heard("out of the skin") == 1; }));
  EXPECT_FALSE(lying().inBody);
  EXPECT_EQ(heard("Vein entered"), 1);
}

/// A key must not pull a needle out of a vessel without its path.
TEST_F(TrainNeedle, InTheBodyItIsNeitherPutAwayNorTakenAnew) {
  openWide();
  overTheVein();
  type("needle_depth", "12");
  ASSERT_TRUE(waitFor([&] { return lying().in == kVein; }));
  for (const auto& act : std::initializer_list<std::function<void()>>{
           [&] { key(Qt::Key_I); }, [&] { child<QPushButton>("needleAcross")->click(); },
           [&] { child<QPushButton>("needleAlong")->click(); }}) {
    said_.clear();
    act();
    EXPECT_EQ(heard("Withdraw it from the skin first"), 1);
    ASSERT_TRUE(hands().needleHand());
    EXPECT_EQ(lying().in, kVein);
  }
  EXPECT_TRUE(child<QPushButton>("needleAlong")->isChecked());
  type("needle_depth", "-5");
  ASSERT_TRUE(waitFor([&] { return !lying().inBody; }));
  key(Qt::Key_I);
  EXPECT_FALSE(hands().needleHand());
}

TEST_F(TrainNeedle, ItsNumbersFitTheNarrowPanel) {
  openWide();
  for (const int width : {1366, 1024}) {
    workspace_->resize(width, 690);
    if (!hands().needleHand()) key(Qt::Key_I);
    QTest::qWait(50);
    auto* area = child<QWidget>("trainControls")->findChild<QScrollArea*>();
    ASSERT_TRUE(area && child<QLineEdit>("needle_depth")->isVisible());
    EXPECT_LE(area->widget()->minimumSizeHint().width(), area->viewport()->width()) << width;
  }
}

TEST_F(TrainNeedle, BoneStopsIt) {
  openWide();
  overTheVein();
  type("needle_depth", "40");
  ASSERT_TRUE(waitFor([&] { return heard("bone") == 1; })) << workspace_->statusText().toStdString();
  EXPECT_TRUE(waitFor([&] { return hands().wantedAdvance_mm() < 32; })) << "the number says where it is";
  EXPECT_LT(hands().needle()->patientFromNeedle.offset.y, 27) << "nothing is drawn in bone";
  key(Qt::Key_PageDown);
  QTest::qWait(200);
  EXPECT_LT(hands().wantedAdvance_mm(), 32);
}

TEST_F(TrainNeedle, WhereItCannotGoIsSaidAndLeavesIt) {
  openWide();
  overTheVein();
  type("needle_depth", "15");
  // All the way: freezing stops it where it is, and the number follows.
  ASSERT_TRUE(waitFor([&] { return std::abs(held().advance_mm - 15) < 1e-9; }));
  key(Qt::Key_W, Qt::AltModifier);
  EXPECT_TRUE(workspace_->statusText().contains("Withdraw the needle to an insertion length of 10 mm"))
      << workspace_->statusText().toStdString();
  key(Qt::Key_Left, Qt::AltModifier);
  EXPECT_TRUE(workspace_->statusText().contains("Withdraw the needle before"));
  type("needle_depth", "99");
  EXPECT_NEAR(hands().wantedAdvance_mm(), 15, 1e-9) << "longer than the needle";
  key(Qt::Key_Space);
  key(Qt::Key_PageUp);
  EXPECT_NEAR(hands().wantedAdvance_mm(), 15, 1e-9) << "frozen";
}

TEST_F(TrainNeedle, ShiftAndTheWheelAdvanceIt) {
  openWide();
  key(Qt::Key_I);
  const double before_mm = hands().wantedAdvance_mm();
  QWheelEvent down(QPointF(40, 40), canvas_->mapToGlobal(QPoint(40, 40)), {}, {0, -120}, Qt::NoButton,
                   Qt::ShiftModifier, Qt::NoScrollPhase, false);
  QApplication::sendEvent(canvas_, &down);
  EXPECT_NEAR(hands().wantedAdvance_mm(), before_mm + 1, 1e-9);
}

TEST_F(TrainNeedle, AnotherCaseAndClosingFindNoNeedleInTheAir) {
  openWide();
  overTheVein();
  type("needle_depth", "8");
  workspace_->setCase(nullptr);
  EXPECT_FALSE(hands().needle());
  openWide();
  overTheVein();
  type("needle_depth", "30");
  QTest::qWait(100);
  workspace_ = nullptr;
}

}  // namespace
}  // namespace insonate::train
