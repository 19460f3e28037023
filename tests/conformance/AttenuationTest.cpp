#include "conformance/Measure.h"
#include "conformance/Rig.h"

#include <cmath>

namespace insonate::test {
namespace {

class Attenuation : public EngineTest {};
INSONATE_FOR_ALL_ENGINES(Attenuation);

constexpr int kLines = 96, kSamples = 400;

/// dB per cm of depth of the frame's RMS across scanlines, between the given shares of the depth.
double fittedSlope_dBpcm(const EnvelopeFrame& frame, double depth_mm, double from, double to) {
  std::vector<double> depth_cm, level_dB;
  const int firstLine = frame.scanlines / 10;
  for (int m = int(from * frame.samples); m < int(to * frame.samples); ++m) {
    double power = 0;
    for (int look = 0; look < frame.looks; ++look) {
      const double r = rms(valuesIn(frame, {m, m + 1, firstLine, frame.scanlines - firstLine}, look));
      power += r * r;
    }
    depth_cm.push_back((m + 0.5) * depth_mm / frame.samples / 10);
    level_dB.push_back(decibel(std::sqrt(power)));
  }
  return slope(depth_cm, level_dB);
}

TEST_P(Attenuation, SlopeIsTwiceAlphaTimesFrequencyToTheExponent) {
  const Probe probe = probeNamed("linear");
  double worst = 0;
  for (const auto& [alpha, exponent] : {std::pair{0.18, 1.0}, {0.7, 1.0}, {0.7, 1.3}, {1.8, 1.0}}) {
    AcousticTable table = plainTable();
    table.tissues[kSoftTissue].attenuation_dBpcmMHz = alpha;
    table.tissues[kSoftTissue].attenuationExponent = exponent;
    const ScenePtr scene = evenScene(probe, settingsFor(probe), table);
    for (const double f_MHz : {5.0, 7.5, 12.0}) {
      ImagingSettings settings = uniformSettings(probe, 16, kSamples);
      settings.frequency_MHz = f_MHz;
      settings.effects.attenuation = true;
      const EnvelopeFrame frame = render(probe, settings, scene);
      const double expected = -2 * alpha * std::pow(f_MHz, exponent);
      // Engines may leave out what lies below -150 dB.
      const double deepest_mm = 10 * 130 / -expected;
      const double measured =
          fittedSlope_dBpcm(frame, settings.depth_mm, 0.1, std::min(0.9, deepest_mm / settings.depth_mm));
      EXPECT_NEAR(measured / expected, 1, 0.05) << "alpha " << alpha << " f " << f_MHz << " n " << exponent;
      worst = std::max(worst, std::abs(measured / expected - 1));
    }
  }
  record("worst_relative_error", worst);
}

TEST_P(Attenuation, SlopeIsRightInSpeckleForEveryProbe) {
  for (const auto& [name, f_MHz] : {std::pair{"linear", 7.5}, {"curvilinear", 3.5}, {"phased", 3.0}}) {
    const Probe probe = probeNamed(name);
    ImagingSettings settings = speckleSettings(probe, kLines, kSamples);
    settings.frequency_MHz = f_MHz, settings.looks = 3;
    settings.depth_mm = std::min(80.0, settings.depth_mm);
    settings.effects.attenuation = true;
    AcousticTable table = plainTable();
    table.tissues[kSoftTissue].attenuation_dBpcmMHz = 0.7;
    const EnvelopeFrame frame = render(probe, settings, evenScene(probe, settings, table));
    const double measured = fittedSlope_dBpcm(frame, settings.depth_mm, 0.1, 0.9);
    EXPECT_NEAR(measured / (-2 * 0.7 * f_MHz), 1, 0.05) << name;
    record(std::string(name) + "_dBpcm", measured);
  }
}

/// Ratio of the echo behind a structure of other attenuation to that at the same depth beside it.
double behindOverBeside(const EnvelopeFrame& frame, const Probe& probe, const ImagingSettings& settings,
                        double behind_mm, double beside_mm, double from_mm, double to_mm) {
  const BeamGrid grid(probe, settings);
  const auto level = [&](double lateral_mm) {
    const auto at = grid.locate(lateral_mm, from_mm);
    const int line = int(std::lround(at.scanline));
    const Window window{int(grid.sampleAt(from_mm)), int(grid.sampleAt(to_mm)), line - 3, line + 4};
    double power = 0;
    for (int look = 0; look < frame.looks; ++look) power += std::pow(rms(valuesIn(frame, window, look)), 2);
    return std::sqrt(power);
  };
  return level(behind_mm) / level(beside_mm);
}

AcousticTable bloodInMuscle() {
  AcousticTable table = plainTable();
  for (AcousticTissue& tissue : table.tissues) tissue.attenuation_dBpcmMHz = 0.96;
  table.tissues[kVein].attenuation_dBpcmMHz = 0.18;
  table.tissues[kVein].echogenicity_dB = -24;
  return table;
}

TEST_P(Attenuation, BloodEnhancesWhatLiesBehind) {
  const Probe probe = probeNamed("linear");
  ImagingSettings settings = uniformSettings(probe, kLines, kSamples, 3);
  settings.effects.attenuation = settings.effects.transmission = true;
  // A vessel of 10 mm across the slice; Z 1.61 against 1.65, as in the table of the model.
  AcousticTable table = bloodInMuscle();
  table.tissues[kSoftTissue].impedance_MRayl = 1.65;
  table.tissues[kVein].impedance_MRayl = 1.61;
  const auto vessel = [](Vec3 p) { return std::hypot(p.x - 3, p.z - 15) < 5 ? kVein : kSoftTissue; };
  const auto slab = [](Vec3 p) { return std::abs(p.x) < 8 && p.z > 8 && p.z < 20 ? kVein : kSoftTissue; };
  const double r = (1.65 - 1.61) / (1.65 + 1.61), passes = std::pow(1 - r * r, 2);
  const auto gain = [&](double thickness_cm) {
    return passes * std::pow(10, 2 * (0.96 - 0.18) * settings.frequency_MHz * thickness_cm / 20);
  };
  const EnvelopeFrame behindVessel = render(probe, settings, sceneAround(probe, settings, 0.5, table, vessel));
  const double ofVessel = behindOverBeside(behindVessel, probe, settings, 3, -12, 25, 35) / gain(1.0);
  EXPECT_NEAR(ofVessel, 1, 0.1);
  record("vessel_over_theory", ofVessel);

  const EnvelopeFrame behindSlab = render(probe, settings, sceneAround(probe, settings, 0.5, table, slab));
  const double ofSlab = behindOverBeside(behindSlab, probe, settings, 0, -14, 25, 35) / gain(1.2);
  EXPECT_NEAR(ofSlab, 1, 0.1);
  record("slab_over_theory", ofSlab);
}

TEST_P(Attenuation, GoesThereAndBackForEchoesOfBoundariesToo) {
  const Probe probe = probeNamed("linear");
  ImagingSettings settings = silentSettings(probe, 16, kSamples);
  settings.effects.attenuation = settings.effects.reflection = true;
  AcousticTable table = plainTable();
  table.tissues[kSoftTissue].attenuation_dBpcmMHz = 0.5;
  table.tissues[kMuscle].impedance_MRayl = 1.7;
  const auto peakAt = [&](double depth_mm) {
    const auto scene =
        sceneAround(probe, settings, 0.5, table, [&](Vec3 p) { return p.z < depth_mm ? kSoftTissue : kMuscle; });
    return peakOf(scanline(render(probe, settings, scene), 8)).value;
  };
  const double lost_dB = decibel(peakAt(10) / peakAt(30));
  const double expected_dB = 2 * 0.5 * settings.frequency_MHz * 2;
  EXPECT_NEAR(lost_dB, expected_dB, 0.05 * expected_dB);
  record("lost_over_expected", lost_dB / expected_dB);
}

}  // namespace
}  // namespace insonate::test
