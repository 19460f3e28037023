#include "ToolsWindow.h"

namespace insonate::prepare {
namespace {

/// Text of the window's last line about a place, received as the window receives it.
class StatusLine : public Tools {
 protected:
  void SetUp() override {
    Tools::SetUp();
    hear();
    QObject::connect(workspace_.get(), &ui::Workspace::statusChanged, workspace_.get(), [this] { hear(); });
  }
  void hear() { heard_ = workspace_->statusText().toStdString(); }
  void hover(Vec3 patient_mm) {
    QMouseEvent move(QEvent::MouseMove, pointOf(patient_mm), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(canvas("Axial slice"), &move);
  }
  bool says(const QString& name) const { return QString::fromStdString(heard_).endsWith("   " + name); }

  std::string heard_;
};

TEST_F(StatusLine, TellsOfTheCrosshairAndFollowsEveryEditUnderIt) {
  EXPECT_TRUE(says("vein")) << heard_;
  shared_->structures.add(kArtery);
  key(Qt::Key_1);
  drag({0, 12, 0}, {1, 12, 0});
  QEvent leave(QEvent::Leave);
  QApplication::sendEvent(canvas("Axial slice"), &leave);
  EXPECT_TRUE(says("artery")) << heard_;
  child<QAction>("undo")->trigger();
  EXPECT_TRUE(says("vein")) << heard_;
  child<QAction>("redo")->trigger();
  EXPECT_TRUE(says("artery")) << heard_;
}

TEST_F(StatusLine, TellsWhatAToolPointsAtAsItIsPainted) {
  shared_->crosshair.moveTo({20, 30, 0});
  ASSERT_TRUE(says("bone")) << heard_;
  shared_->structures.add(kArtery);
  key(Qt::Key_1);
  hover({-12, 14, 0});
  EXPECT_TRUE(says("soft tissue")) << heard_;
  EXPECT_NE(heard_.find("30 HU"), std::string::npos) << heard_;
  drag({-12, 14, 0}, {-11, 14, 0});
  EXPECT_TRUE(says("artery")) << "and the crosshair is elsewhere: " << heard_;
  key(Qt::Key_Escape);
  EXPECT_TRUE(says("bone")) << "no tool, the crosshair again: " << heard_;
}

TEST_F(StatusLine, AnotherSliceUnderAStillPointerIsToldOf) {
  key(Qt::Key_1);
  hover({-12, 14, 0});
  const std::string before = heard_;
  key(Qt::Key_Up);
  EXPECT_NE(heard_, before);
  EXPECT_NE(heard_.find("1.0) mm"), std::string::npos) << heard_;
}

TEST_F(StatusLine, ANewNameIsReadAtOnce) {
  shared_->structures.add(test::kOwnLabel);
  key(Qt::Key_1);
  drag({0, 12, 0}, {1, 12, 0});
  shared_->terms.setName(test::kOwnLabel, "anterior jugular");
  EXPECT_TRUE(says("anterior jugular")) << heard_;
  child<QAction>("undo")->trigger();
  EXPECT_FALSE(says("anterior jugular")) << heard_;
}

TEST_F(StatusLine, ACaseWithoutAPlaceToBeginIsEnteredInTheMiddleOfAVoxel) {
  PatientCase even = test::smallCase();
  even.manifest.startPoses.clear();
  VolumeGeometry grid = even.ct.geometry;
  grid.size = {48, 40, 16};
  even.ct = CtVolume(grid, -1000), even.labels = LabelMap(grid);
  workspace_->setCase(std::make_shared<const PatientCase>(std::move(even)));
  const Vec3 index = grid.indexFromPatient() * shared_->crosshair.position_mm();
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(index[axis], grid.size[axis] / 2, 1e-9);
}

}  // namespace
}  // namespace insonate::prepare
