#include "TrainWindow.h"

#include <insonate/ui/ValueSlider.h>
#include <insonate/views/UltrasoundView.h>

#include <QCheckBox>
#include <QSettings>
#include <algorithm>
#include <cmath>

namespace insonate::train {
namespace {

/// Color Doppler over the live image.
class TrainDoppler : public TrainWindow {
 protected:
  bool waitFor(const std::function<bool()>& done) { return QTest::qWaitFor(done, kPatience_ms); }
  const ColorImage& shown() { return model_->live.shown()->color; }
  /// Position of a corner of the color box on the canvas.
  QPoint cornerAt(int corner) {
    const ImagingModel& imaging = model_->imaging;
    const Vec3 at = colorBoxCorners(imaging.probe(), imaging.settings(), imaging.color())[corner];
    const auto& view = static_cast<const views::UltrasoundView&>(child<ui::ViewWidget>("ultrasoundView")->view());
    const views::DisplayPoint px = view.displayFromImage({at.x, at.z});
    const double ratio = canvas_->devicePixelRatioF();
    return {int(std::lround(px.x / ratio)), int(std::lround(px.y / ratio))};
  }
};

TEST_F(TrainDoppler, TheKeySwitchesColorOnAndOff) {
  openCase();
  EXPECT_TRUE(shown().empty());
  key(Qt::Key_D, Qt::ControlModifier);
  ASSERT_TRUE(waitFor([&] { return !shown().empty(); }));
  EXPECT_TRUE(child<QCheckBox>("color")->isChecked());
  EXPECT_TRUE(child<ui::ValueSlider>("colorScale")->isVisibleTo(workspace_.get()));
  key(Qt::Key_D, Qt::ControlModifier);
  EXPECT_TRUE(waitFor([&] { return shown().empty(); }));
  EXPECT_FALSE(child<ui::ValueSlider>("colorScale")->isVisibleTo(workspace_.get()));
}

TEST_F(TrainDoppler, TheScaleIsTheVelocityAtWhichColorsAlias) {
  openCase();
  child<QCheckBox>("color")->click();
  child<ui::ValueSlider>("colorScale")->setValue(30);
  EXPECT_NEAR(nyquistVelocity_mmps(model_->imaging.color()), 300, 0.5);
  ASSERT_TRUE(waitFor([&] { return std::abs(shown().nyquist_mmps - 300) < 0.5; }));
  child<QCheckBox>("colorInvert")->click();
  EXPECT_TRUE(model_->imaging.setup().color->invert);
  model_->history.undo();
  EXPECT_FALSE(model_->imaging.color().invert && model_->imaging.isColorOn());
}

TEST_F(TrainDoppler, DraggingABorderMovesTheBoxAndACornerResizesIt) {
  openCase();
  model_->imaging.setColor(true, model_->imaging.color());
  ASSERT_TRUE(waitFor([&] { return !shown().empty(); }));
  const ColorSettings before = model_->imaging.color();
  const Transform pose = model_->motion.pose();
  const QPoint border = (cornerAt(0) + cornerAt(1)) / 2;
  drag(Qt::LeftButton, border, border + QPoint(20, 15));
  const ColorSettings moved = model_->imaging.color();
  EXPECT_GT(moved.left, before.left);
  EXPECT_NEAR(moved.right - moved.left, before.right - before.left, 1e-9);
  EXPECT_GT(moved.near_mm, before.near_mm);
  EXPECT_NEAR(moved.far_mm - moved.near_mm, before.far_mm - before.near_mm, 1e-9);
  drag(Qt::LeftButton, cornerAt(0), cornerAt(0) + QPoint(15, 10));
  const ColorSettings resized = model_->imaging.color();
  EXPECT_GT(resized.left, moved.left);
  EXPECT_EQ(resized.right, moved.right);
  EXPECT_GT(resized.near_mm, moved.near_mm);
  EXPECT_EQ(resized.far_mm, moved.far_mm);
  EXPECT_EQ(model_->motion.pose(), pose) << "the probe stays";
}

TEST_F(TrainDoppler, SettingsStayWithinWhatTheProbePermits) {
  openCase();
  ColorSettings color = model_->imaging.color();
  color.far_mm = 1000, color.prf_Hz = 1e6, color.left = 2;
  model_->imaging.setColor(true, color);
  EXPECT_TRUE(validate(*model_->imaging.setup().color, model_->imaging.probe(), model_->imaging.settings()));
  ImagingSettings shallow = model_->imaging.settings();
  shallow.depth_mm = model_->imaging.probe().minDepth_mm;
  model_->imaging.setSettings(shallow);
  const ImagingSetup setup = model_->imaging.setup();
  EXPECT_TRUE(validate(*setup.color, setup.probe, setup.settings));
  model_->imaging.setProbe("phased");
  const ImagingSetup fan = model_->imaging.setup();
  EXPECT_TRUE(validate(*fan.color, fan.probe, fan.settings));
}

}  // namespace
}  // namespace insonate::train
