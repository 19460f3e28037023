#include "conformance/Rig.h"

#include <insonate/ultrasound/SpectralDoppler.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate::test {
namespace {

/// A straight vessel at 60 degrees to the beam, at a depth of 20 mm in the middle of the image.
class Spectral : public testing::Test {
 protected:
  Spectral() {
    // A slice so thick that the whole vessel is in it.
    probe_.elementHeight_mm = 14, probe_.elevationFocus_mm = 60;
    settings_ = silentSettings(probe_, 128, 500, 3);
    gate_.angle_deg = kAngle_deg, gate_.wallFilter_Hz = 0;
    AcousticTable table = plainTable();
    table.tissues[kVein].echogenicity_dB = -20;
    table.tissues[kSoftTissue].echogenicity_dB = -120;
    scene_ = sceneAround(probe_, settings_, 0.3, table,
                         [&](Vec3 p) { return offAxis_mm(p) < kRadius_mm ? kVein : kSoftTissue; });
  }
  static Vec3 direction() {
    const double angle = kAngle_deg * std::numbers::pi / 180;
    return {std::sin(angle), 0, -std::cos(angle)};
  }
  static double offAxis_mm(Vec3 p) {
    const Vec3 from = p - Vec3{0, 0, 20};
    return norm(from - direction() * dot(from, direction()));
  }
  std::vector<double> spectrumOf(double speed_mmps, bool parabolic) {
    BloodTube tube;
    tube.label = kVein;
    for (const double along_mm : {-60.0, 0.0, 60.0})
      tube.course.push_back({Vec3{0, 0, 20} + direction() * along_mm, direction(), kRadius_mm, 1});
    for (int i = 0; i < BloodTube::kProfile; ++i) {
      const double x = double(i) / (BloodTube::kProfile - 1);
      tube.profile_mmps[i] = speed_mmps * (parabolic ? 1 - x * x : 1);
    }
    const BloodFlow flow{{tube}};
    std::vector<double> power;
    SpectralDoppler(probe_, settings_, gate_).spectrum(*scene_, {}, {}, {.blood = &flow}, power);
    return power;
  }
  double peakVelocity_mmps(const std::vector<double>& power) const {
    return binVelocity_mmps(gate_, int(std::ranges::max_element(power) - power.begin()));
  }

  static constexpr double kAngle_deg = 60, kRadius_mm = 1.2;
  Probe probe_ = probeNamed("linear");
  ImagingSettings settings_;
  SpectralSettings gate_;
  ScenePtr scene_;
};

TEST_F(Spectral, PlugFlowIsALineAtItsVelocityWithinThreePercent) {
  EXPECT_NEAR(peakVelocity_mmps(spectrumOf(400, false)), 400, 12);
  EXPECT_NEAR(peakVelocity_mmps(spectrumOf(-400, false)), -400, 12);
  const SpectrumVelocities velocities = velocitiesOf(spectrumOf(400, false), gate_);
  EXPECT_NEAR(velocities.mean_mmps, 400, 12);
  EXPECT_NEAR(velocities.envelope_mmps, 400, 40);
}

/// Each velocity of a parabola has the same area in the cross-section.
TEST_F(Spectral, AParabolicProfileIsFlatWithinOneDecibel) {
  gate_.gate_mm = 8;
  const std::vector<double> power = spectrumOf(500, true);
  double low = 1e30, high = 0;
  for (int bin = 0; bin < kSpectrumBins; ++bin) {
    const double velocity = binVelocity_mmps(gate_, bin);
    if (velocity < 75 || velocity > 425) continue;
    low = std::min(low, power[bin]), high = std::max(high, power[bin]);
  }
  EXPECT_LT(10 * std::log10(high / low), 2) << "within 1 dB of the middle";
  for (int bin = 0; bin < kSpectrumBins; ++bin)
    if (const double velocity = binVelocity_mmps(gate_, bin); velocity > 620 || velocity < -120) {
      EXPECT_LT(power[bin], 0.01 * high) << velocity;
    }
}

TEST_F(Spectral, VelocitiesAboveTheNyquistVelocityAlias) {
  const double nyquist = nyquistVelocity_mmps(gate_);
  EXPECT_NEAR(peakVelocity_mmps(spectrumOf(1.2 * nyquist, false)), -0.8 * nyquist, 0.03 * nyquist);
}

TEST_F(Spectral, TheWallFilterRemovesSlowFlow) {
  const auto total = [](const std::vector<double>& power) {
    double sum = 0;
    for (const double bin : power) sum += bin;
    return sum;
  };
  const double before = total(spectrumOf(30, false));
  gate_.wallFilter_Hz = 400;
  EXPECT_LT(total(spectrumOf(30, false)), 1e-3 * before);
  EXPECT_NEAR(total(spectrumOf(600, false)) / before, 1, 0.1);
}

TEST_F(Spectral, SettingsAreReadAndChecked) {
  gate_.range_mm = 12.5;
  EXPECT_EQ(*spectralFromJson(jsonOf(gate_), {}), gate_);
  EXPECT_NE(spectralFromJson({{"depth", 3}}, {}).error().message.find("depth"), std::string::npos);
  EXPECT_TRUE(validate(gate_, probe_, settings_));
  gate_.range_mm = 39.5;
  EXPECT_NE(validate(gate_, probe_, settings_).error().message.find("range_mm"), std::string::npos);
  gate_.range_mm = 30, gate_.prf_Hz = 30000;
  EXPECT_NE(validate(gate_, probe_, settings_).error().message.find("prf_Hz"), std::string::npos);
}

TEST_F(Spectral, TheWaterfallShowsTheSpectraAndRepeats) {
  std::vector<std::vector<double>> spectra(20, std::vector<double>(kSpectrumBins));
  for (auto& spectrum : spectra) spectrum[200] = 1e4;
  const SpectrumImage image = waterfallOf(spectra, gate_, 1);
  ASSERT_EQ(image.columns, 20);
  double line = 0, noise = 0;
  for (int column = 0; column < 20; ++column) {
    line += image.gray[std::size_t(kSpectrumBins - 1 - 200) * 20 + column] / 20.0;
    noise += image.gray[std::size_t(kSpectrumBins - 1 - 60) * 20 + column] / 20.0;
  }
  EXPECT_GT(line, 240);
  EXPECT_LT(noise, 40);
  EXPECT_EQ(waterfallOf(spectra, gate_, 1).gray, image.gray);
  EXPECT_NE(waterfallOf(spectra, gate_, 2).gray, image.gray);
}

}  // namespace
}  // namespace insonate::test
