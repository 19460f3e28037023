#include "TrainWindow.h"

#include <insonate/ui/Sound.h>
#include <insonate/ui/ValueSlider.h>
#include <insonate/views/UltrasoundView.h>

#include <trace/MModeStrip.h>
#include <trace/SpectrumStrip.h>
#include <trace/TraceModel.h>

#include <QCheckBox>
#include <QSettings>
#include <algorithm>
#include <cmath>

namespace insonate::train {
namespace {

/// PW Doppler and M-mode under the live image.
class TrainTrace : public TrainWindow {
 protected:
  bool waitFor(const std::function<bool()>& done) { return QTest::qWaitFor(done, kPatience_ms); }
  SpectrumStrip* spectrum() { return child<SpectrumStrip>("spectrum"); }
  MModeStrip* mMode() { return child<MModeStrip>("mMode"); }
  const views::UltrasoundView& view() {
    return static_cast<const views::UltrasoundView&>(child<ui::ViewWidget>("ultrasoundView")->view());
  }
  /// Position on the canvas of a point of a line over the image, at a fraction of its length.
  QPoint onLine(std::size_t line, double part) {
    const views::LineOverlay& shown = view().lines().at(line);
    const views::ImagePoint at{shown.from.lateral_mm + part * (shown.to.lateral_mm - shown.from.lateral_mm),
                               shown.from.axial_mm + part * (shown.to.axial_mm - shown.from.axial_mm)};
    const views::DisplayPoint px = view().displayFromImage(at);
    const double ratio = canvas_->devicePixelRatioF();
    return {int(std::lround(px.x / ratio)), int(std::lround(px.y / ratio))};
  }
  double gateDepth_mm() { return (view().lines().at(2).from.axial_mm + view().lines().at(3).from.axial_mm) / 2; }
  double gateLateral_mm() { return (view().lines().at(2).from.lateral_mm + view().lines().at(2).to.lateral_mm) / 2; }
};

TEST_F(TrainTrace, TheKeysSwitchTheTracesOnAndOff) {
  openCase();
  EXPECT_FALSE(spectrum()->isVisibleTo(workspace_.get()));
  EXPECT_TRUE(view().lines().empty());
  key(Qt::Key_W, Qt::ControlModifier);
  EXPECT_TRUE(spectrum()->isVisibleTo(workspace_.get()));
  EXPECT_TRUE(child<QCheckBox>("pwDoppler")->isChecked());
  EXPECT_TRUE(child<ui::ValueSlider>("pwScale")->isVisibleTo(workspace_.get()));
  EXPECT_TRUE(waitFor([&] { return spectrum()->columns() > 100; })) << "spectra come without a pulse, too";
  key(Qt::Key_M, Qt::ControlModifier);
  EXPECT_TRUE(mMode()->isVisibleTo(workspace_.get()));
  key(Qt::Key_W, Qt::ControlModifier);
  key(Qt::Key_M, Qt::ControlModifier);
  EXPECT_FALSE(spectrum()->isVisibleTo(workspace_.get()) || mMode()->isVisibleTo(workspace_.get()));
  EXPECT_TRUE(view().lines().empty());
}

TEST_F(TrainTrace, AFreezeStopsTheSpectrum) {
  openCase();
  child<QCheckBox>("pwDoppler")->click();
  ASSERT_TRUE(waitFor([&] { return spectrum()->columns() > 20; }));
  model_->live.setFrozen(true);
  QTest::qWait(100);
  const std::size_t columns = spectrum()->columns();
  QTest::qWait(200);
  EXPECT_EQ(spectrum()->columns(), columns);
  child<ui::ValueSlider>("pwAngle")->setValue(60);
  child<ui::ValueSlider>("pwBaseline")->setValue(25);
  EXPECT_GT(spectrum()->columns(), 20U) << "the frozen spectrum stays";
  model_->live.setFrozen(false);
  EXPECT_TRUE(waitFor([&] { return spectrum()->columns() > columns + 20; }));
}

TEST_F(TrainTrace, TheMouseMovesGateLineAndAngle) {
  openCase();
  child<QCheckBox>("pwDoppler")->click();
  const Transform pose = model_->motion.pose();
  ASSERT_EQ(view().lines().size(), 5U);
  const double depth_mm = gateDepth_mm(), lateral_mm = gateLateral_mm();
  // The middle of the gate is that of the line of flow.
  drag(Qt::LeftButton, onLine(4, 0.5), onLine(4, 0.5) + QPoint(30, 25));
  EXPECT_GT(gateDepth_mm(), depth_mm + 0.5);
  EXPECT_GT(gateLateral_mm(), lateral_mm + 0.5);
  const double deeper_mm = gateDepth_mm(), further_mm = gateLateral_mm();
  drag(Qt::LeftButton, onLine(0, 0.3), onLine(0, 0.3) + QPoint(-25, 10));
  EXPECT_NEAR(gateDepth_mm(), deeper_mm, 1e-6) << "the line moves sideways only";
  EXPECT_LT(gateLateral_mm(), further_mm - 0.5);
  EXPECT_EQ(child<ui::ValueSlider>("pwAngle")->value(), 0);
  drag(Qt::LeftButton, onLine(4, 1), onLine(4, 0.5) + QPoint(60, 60));
  EXPECT_NEAR(child<ui::ValueSlider>("pwAngle")->value(), 45, 4);
  EXPECT_EQ(model_->motion.pose(), pose) << "the probe stays";
}

TEST_F(TrainTrace, KeysMoveTheGate) {
  openCase();
  child<QCheckBox>("pwDoppler")->click();
  const double depth_mm = gateDepth_mm(), lateral_mm = gateLateral_mm();
  key(Qt::Key_Down, Qt::ControlModifier);
  EXPECT_NEAR(gateDepth_mm(), depth_mm + 1, 1e-6);
  key(Qt::Key_Right, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_NEAR(gateLateral_mm(), lateral_mm + 5, 0.2);
}

TEST_F(TrainTrace, ScaleIsCorrectedByTheAngleAndKeptWithinThePossible) {
  openCase();
  child<QCheckBox>("pwDoppler")->click();
  child<ui::ValueSlider>("pwAngle")->setValue(60);
  child<ui::ValueSlider>("pwScale")->setValue(100);
  EXPECT_NEAR(child<ui::ValueSlider>("pwScale")->value(), 100, 1);
  child<ui::ValueSlider>("pwBaseline")->setValue(25);
  ImagingSettings shallow = model_->imaging.settings();
  shallow.depth_mm = model_->imaging.probe().minDepth_mm;
  model_->imaging.setSettings(shallow);
  EXPECT_LT(gateDepth_mm(), shallow.depth_mm);
  ASSERT_TRUE(waitFor([&] { return spectrum()->columns() > 20; }));
  model_->imaging.setProbe("phased");
  EXPECT_TRUE(waitFor([&] { return spectrum()->columns() > 60; }));
}

TEST_F(TrainTrace, MModeScrollsTheImagesOfAPulsatingVessel) {
  openCase();
  TissueChoice choice = model_->imaging.tissue();
  choice.pulse = choice.breathing = true;
  model_->imaging.setTissue(choice);
  child<QCheckBox>("mModeOn")->click();
  ASSERT_TRUE(waitFor([&] { return mMode()->columns() > 30; }));
  int brightest = 0;
  for (int row = 0; row < MModeStrip::kRows; ++row) brightest = std::max(brightest, mMode()->grayAt(2, row));
  EXPECT_GT(brightest, 60);
  model_->live.setFrozen(true);
  const std::size_t columns = mMode()->columns();
  model_->live.showCine(0);
  EXPECT_EQ(mMode()->columns(), columns) << "past images are not appended";
}

/// Columns scroll in the order of their times; a break in time leaves a narrow gap.
TEST(TraceStrip, KeepsTheLatestColumnsAndMarksBreaks) {
  SpectrumStrip strip;
  strip.setDuration(2);
  std::vector<LiveSpectrum> spectra;
  const SpectralSettings gate;
  strip.setGate(gate);
  for (int i = 0; i < 1000; ++i) {
    LiveSpectrum spectrum{i * kSpectrumStep_s, std::vector<double>(kSpectrumBins), gate};
    if (i == 999) std::ranges::fill(spectrum.power, 1e6);
    spectra.push_back(spectrum);
  }
  strip.append(spectra);
  EXPECT_EQ(strip.columns(), 1000U);
  EXPECT_GT(strip.grayAt(0, 100), 200);
  EXPECT_LT(strip.grayAt(1, 100), 120);
  spectra.resize(1);
  spectra[0].time_s = 60;
  strip.append(spectra);
  EXPECT_EQ(strip.columns(), 1004U);
  spectra.clear();
  SpectralSettings faster = gate;
  faster.prf_Hz = 8000;
  strip.setGate(faster);
  EXPECT_EQ(strip.columns(), 0U) << "another axis";
  spectra.push_back({61, std::vector<double>(kSpectrumBins), gate});
  strip.append(spectra);
  EXPECT_EQ(strip.columns(), 0U) << "spectra of the former axis";
}

/// Angle, baseline and gain are settings of the display: the strip shows the same spectra with the new setting, also
/// those of a frozen image.
TEST(TraceStrip, AngleBaselineAndGainChangeTheShownSpectra) {
  SpectralSettings gate;
  std::vector<LiveSpectrum> spectra;
  for (int i = 0; i < 700; ++i) {
    LiveSpectrum spectrum{i * kSpectrumStep_s, std::vector<double>(kSpectrumBins), gate};
    std::fill_n(spectrum.power.begin() + 150, 20, 1e3 * (1 + i % 7));
    spectra.push_back(spectrum);
  }
  SpectrumStrip strip, anew;
  for (SpectrumStrip* each : {&strip, &anew}) each->setDuration(2);
  strip.setGate(gate);
  strip.append(spectra);
  const auto expectShown = [&](const char* what) {
    anew.clear();
    anew.setGate(gate);
    anew.append(spectra);
    for (std::size_t back = 0; back < 400; back += 57)
      for (int row = 0; row < kSpectrumBins; ++row)
        ASSERT_EQ(strip.grayAt(back, row), anew.grayAt(back, row)) << what << ", " << back << ", row " << row;
  };
  expectShown("as it is");
  const QString slower = strip.accessibleName();
  gate.angle_deg = 60;
  strip.setGate(gate);
  EXPECT_GT(strip.columns(), 0U);
  EXPECT_NE(strip.accessibleName(), slower) << "the angle corrects the velocity";
  expectShown("angle");
  gate.baseline = 0.25;
  strip.setGate(gate);
  expectShown("baseline");
  gate.gain_dB = -12;
  strip.setGate(gate);
  expectShown("gain");
}

}  // namespace
}  // namespace insonate::train
