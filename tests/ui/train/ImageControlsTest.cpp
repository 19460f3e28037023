#include "TrainWindow.h"

#include <insonate/ultrasound/BeamGrid.h>
#include <insonate/views/UltrasoundView.h>

#include <cmath>

namespace insonate::train {
namespace {

TEST_F(TrainWindow, EachSliderChangesItsSetting) {
  const auto set = [&](const char* name, double value) { child<ui::ValueSlider>(name)->setValue(value); };
  set("depth", 60), set("gain", 7), set("frequency", 9), set("focus", 31), set("dynamicRange", 75);
  set("persistence", 0.4), set("speckleReduction", 0.75), set("edgeEnhancement", 0.3), set("noise", -37);
  set("dynamicFilter", 0.7);
  set("steering", -7), set("ringing", 33), set("poorContactLeft", 2.5), set("poorContactRight", 4);
  const ImagingSettings& settings = model_->imaging.settings();
  EXPECT_EQ(settings.depth_mm, 60);
  EXPECT_EQ(settings.gain_dB, 7);
  EXPECT_EQ(settings.frequency_MHz, 9);
  EXPECT_EQ(settings.focus_mm, 31);
  EXPECT_EQ(settings.dynamicRange_dB, 75);
  EXPECT_EQ(settings.persistence, 0.4);
  EXPECT_EQ(settings.speckleReduction, 0.75);
  EXPECT_EQ(settings.edgeEnhancement, 0.3);
  EXPECT_EQ(settings.noise_dB, -37);
  EXPECT_EQ(settings.dynamicFilter, 0.7);
  EXPECT_EQ(settings.steering_deg, -7);
  EXPECT_EQ(settings.ringing_dB, 33);
  EXPECT_EQ(settings.poorContactLeft_mm, 2.5);
  EXPECT_EQ(settings.poorContactRight_mm, 4);

  auto* tgc = child<QWidget>("tgc");
  QTest::mouseClick(tgc, Qt::LeftButton, {}, {tgc->width() - 1, tgc->height() - 1});
  EXPECT_EQ(settings.tgc_dB[7], 20);
  EXPECT_EQ(settings.tgc_dB[0], 0);
}

/// Width of the mark over the left end of the image, in pixels: a letter or a word.
int widthOfLeftMark(const QImage& canvas, const views::UltrasoundView& view, const ImagingSetup& setup) {
  const BeamGrid grid(setup.probe, setup.settings);
  const views::DisplayPoint corner = view.displayFromImage({grid.minLateral_mm(), grid.minAxial_mm()});
  int first = canvas.width(), last = 0;
  for (int y = std::max(0, int(corner.y) - 22); y < int(corner.y) - 3; ++y)
    for (int x = int(corner.x); x < int(corner.x) + 60; ++x)
      if (qGray(canvas.pixel(x, y)) > 130) first = std::min(first, x), last = std::max(last, x);
  return std::max(0, last - first + 1);
}

TEST_F(TrainWindow, TheSidesOfTheImageFollowTheTurnOfTheProbe) {
  openCase();
  settle();
  const auto& view = static_cast<const views::UltrasoundView&>(child<ui::ViewWidget>("ultrasoundView")->view());
  const auto width = [&] { return widthOfLeftMark(canvas_->grab().toImage(), view, *model_->live.shown()->setup); };
  EXPECT_TRUE(QTest::qWaitFor([&] { return width() > 3 && width() < 16; }, kPatience_ms)) << width() << ": R";
  auto* rotation = child<QLineEdit>("rotation");
  rotation->setFocus();
  rotation->selectAll();
  QTest::keyClicks(rotation, "90");
  QTest::keyClick(rotation, Qt::Key_Return);
  ASSERT_NEAR(std::abs(model_->motion.pose().linear.column[0].z), 1, 0.2);
  settle();
  EXPECT_TRUE(QTest::qWaitFor([&] { return width() > 24; }, kPatience_ms)) << width() << ": Head or Foot";
}

TEST_F(TrainWindow, LateralGainIsDrawnFromLeftToRight) {
  auto* lateral = child<QWidget>("lateralGain");
  QTest::mouseClick(lateral, Qt::LeftButton, {}, {lateral->width() - 1, 0});
  EXPECT_EQ(model_->imaging.settings().lateralGain_dB[7], 20);
  EXPECT_EQ(model_->imaging.settings().lateralGain_dB[0], 0);
  QTest::keyClick(lateral, Qt::Key_Left);
  QTest::keyClick(lateral, Qt::Key_Down);
  EXPECT_EQ(model_->imaging.settings().lateralGain_dB[6], -1);
  EXPECT_EQ(model_->imaging.settings().tgc_dB, (std::array<double, 8>{})) << "the other sliders stay";
}

void choose(QComboBox* list, const QString& text) {
  const int index = list->findText(text);
  ASSERT_GE(index, 0) << text.toStdString();
  list->setCurrentIndex(index);
  Q_EMIT list->activated(index);
}

TEST_F(TrainWindow, AMachineBringsItsSettingsUntilOneIsChanged) {
  auto* machine = child<QComboBox>("machine");
  EXPECT_EQ(machine->currentIndex(), -1);
  child<ui::ValueSlider>("depth")->setValue(33);
  choose(machine, "hand-held, 2024");
  EXPECT_EQ(model_->imaging.settings().scanlines, 128);
  EXPECT_EQ(model_->imaging.settings().noise_dB, -38);
  EXPECT_EQ(model_->imaging.settings().depth_mm, 33);
  EXPECT_EQ(child<ui::ValueSlider>("noise")->value(), -38);
  EXPECT_EQ(child<QComboBox>("grayMap")->currentText(), "contrast");
  EXPECT_EQ(machine->currentText(), "hand-held, 2024");
  choose(child<QComboBox>("grayMap"), "dark");
  EXPECT_EQ(model_->imaging.settings().grayMap, GrayMap::Dark);
  EXPECT_EQ(machine->currentIndex(), -1) << "a setting is not the machine's any more";
  undoStep(model_->history, model_->status);
  undoStep(model_->history, model_->status);
  EXPECT_EQ(model_->imaging.settings().scanlines, ImagingSettings{}.scanlines);
}

TEST_F(TrainWindow, HowTheImageWasMadeComesBack) {
  choose(child<QComboBox>("machine"), "cart, 2008");
  child<ui::ValueSlider>("poorContactLeft")->setValue(3);
  ImagingSettings drawn = model_->imaging.settings();
  drawn.lateralGain_dB[3] = -6;
  model_->imaging.setSettings(drawn);
  const test::TemporaryFolder folder;
  QSettings stored(QString::fromStdString((folder / "settings.ini").string()), QSettings::IniFormat);
  workspace_->saveLayout(stored);
  TrainWorkspace other;
  other.restoreLayout(stored);
  const ImagingSettings& back = other.findChild<TrainModel*>()->imaging.settings();
  EXPECT_EQ(other.findChild<QComboBox*>("machine")->currentText(), "cart, 2008");
  EXPECT_EQ(back.scanlines, 192);
  EXPECT_EQ(back.poorContactLeft_mm, 3);
  EXPECT_EQ(back.lateralGain_dB[3], -6);
  stored.setValue("grayMap", 99);
  stored.setValue("scanlines", -3);
  other.restoreLayout(stored);
  EXPECT_TRUE(validate(back, other.findChild<TrainModel*>()->imaging.probe())) << "whatever was stored";
}

TEST_F(TrainWindow, CompoundingIsChosenByTheNumberOfAngles) {
  auto* compounding = child<QComboBox>("compounding");
  EXPECT_EQ(compounding->currentText(), "off");
  compounding->setCurrentIndex(compounding->findData(3));
  Q_EMIT compounding->activated(compounding->currentIndex());
  EXPECT_EQ(model_->imaging.settings().compoundingAngles, 3);
  child<QCheckBox>("harmonic")->click();
  EXPECT_TRUE(model_->imaging.settings().harmonic);
}

}  // namespace
}  // namespace insonate::train
