#include "conformance/Measure.h"
#include "conformance/Rig.h"

#include <cmath>

namespace insonate::test {
namespace {

class Speckle : public EngineTest {};
INSONATE_FOR_ALL_ENGINES(Speckle);

constexpr int kLines = 256, kSamples = 400;
const char* const kProbes[] = {"linear", "curvilinear", "phased"};

/// Without the rim, where part of the beam's width is missing.
Window inner(const EnvelopeFrame& frame) {
  const int rim = frame.scanlines / 12;
  return {frame.samples / 20, frame.samples - frame.samples / 20, rim, frame.scanlines - rim};
}

/// RMS over all looks of a band of depth.
double bandRms(const EnvelopeFrame& frame, double from, double to) {
  const Window w = inner(frame);
  double power = 0;
  for (int look = 0; look < frame.looks; ++look)
    power += std::pow(
        rms(valuesIn(frame, {int(from * frame.samples), int(to * frame.samples), w.firstLine, w.endLine}, look)), 2);
  return std::sqrt(power / frame.looks);
}

double meanOverSd(const EnvelopeFrame& frame, int look = 0) {
  const auto values = valuesIn(frame, inner(frame), look);
  return mean(values) / standardDeviation(values);
}

/// One frame a probe and number of planes answers for Rayleigh statistics, independent looks and level at every depth.
TEST_P(Speckle, IsFullyDevelopedForEveryProbeAndSlice) {
  for (const char* name : kProbes)
    for (const int planes : {1, 3, 5}) {
      const Probe probe = probeNamed(name);
      ImagingSettings settings = speckleSettings(probe, kLines, kSamples, planes);
      settings.looks = 3, settings.depth_mm = std::min(90.0, settings.depth_mm);
      const Transform pose;
      const EnvelopeFrame frame = render(probe, settings, evenScene(probe, settings, plainTable(), pose), pose);
      const std::string which = std::string(name) + "_planes_" + std::to_string(planes);
      for (int look = 0; look < 3; ++look) {
        const double ratio = meanOverSd(frame, look);
        const double log_dB = standardDeviation(decibels(valuesIn(frame, inner(frame), look)));
        EXPECT_NEAR(ratio, 1.91, 0.1) << which << " look " << look;
        EXPECT_NEAR(log_dB, 5.57, 0.4) << which << " look " << look;
        record(which + "_look_" + std::to_string(look) + "_mean_over_sd", ratio);
        record(which + "_look_" + std::to_string(look) + "_log_sd_dB", log_dB);
        if (look == 0) continue;
        const double shared = correlation(valuesIn(frame, inner(frame)), valuesIn(frame, inner(frame), look));
        EXPECT_LT(std::abs(shared), 0.1) << which << ": looks must be independent";
      }
      for (const double from : {0.05, 0.2, 0.4, 0.6, 0.75}) {
        const double level_dB = decibel(bandRms(frame, from, from + 0.2));
        EXPECT_NEAR(level_dB, 0, 0.5) << which << " from " << from << " of the depth";
        record(which + "_level_dB_from_" + std::to_string(int(100 * from)) + "_percent", level_dB);
      }
    }
}

TEST_P(Speckle, LevelIsTheTissuesEchogenicity) {
  const Probe probe = probeNamed("linear");
  const ImagingSettings settings = speckleSettings(probe, kLines, kSamples, 3);
  const double unit = bandRms(render(probe, settings, evenScene(probe, settings)), 0.05, 0.95);
  for (const double echo_dB : {-24.0, 11.5}) {
    AcousticTable table = plainTable();
    table.tissues[kSoftTissue].echogenicity_dB = echo_dB;
    const double level = bandRms(render(probe, settings, evenScene(probe, settings, table)), 0.05, 0.95);
    EXPECT_NEAR(decibel(level / unit), echo_dB, 0.01);
  }
}

TEST_P(Speckle, KeepsItsPowerForOtherFrequenciesFociAndGrids) {
  const Probe probe = probeNamed("linear");
  double worst_dB = 0;
  for (const double f_MHz : {5.0, 13.0})
    for (const double focus_mm : {8.0, 35.0})
      for (const int samples : {400, 1037}) {
        ImagingSettings settings = speckleSettings(probe, 200, samples, 3);
        settings.frequency_MHz = f_MHz, settings.focus_mm = focus_mm, settings.looks = 3;
        const EnvelopeFrame frame = render(probe, settings, evenScene(probe, settings));
        for (const double from : {0.05, 0.4, 0.75}) {
          const double off_dB = decibel(bandRms(frame, from, from + 0.2));
          EXPECT_NEAR(off_dB, 0, 0.5) << f_MHz << " MHz, focus " << focus_mm << " mm, " << samples << " samples";
          worst_dB = std::max(worst_dB, std::abs(off_dB));
        }
        EXPECT_NEAR(meanOverSd(frame), 1.91, 0.1) << f_MHz << " " << focus_mm << " " << samples;
      }
  record("worst_off_dB", worst_dB);
}

TEST_P(Speckle, HoweverTheProbeIsHeld) {
  const Probe probe = probeNamed("linear");
  ImagingSettings settings = speckleSettings(probe, kLines, kSamples, 3);
  settings.looks = 3;
  double worst = 0;
  for (const Vec3 axis : {Vec3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, -2, 3}})
    for (const double angle_deg : {22.0, 50.0}) {
      const Transform pose = turned(axis, angle_deg, {0, 0, 20});
      const EnvelopeFrame frame = render(probe, settings, evenScene(probe, settings, plainTable(), pose), pose);
      EXPECT_NEAR(decibel(bandRms(frame, 0.05, 0.95)), 0, 0.5) << angle_deg << " degrees";
      const double ratio = meanOverSd(frame);
      EXPECT_NEAR(ratio, 1.91, 0.1) << angle_deg << " degrees";
      worst = std::max(worst, std::abs(ratio - 1.91));
    }
  record("worst_mean_over_sd_off", worst);
}

}  // namespace
}  // namespace insonate::test
