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
    SpectralDoppler doppler(probe_, settings_, gate_);
    doppler.hold(*scene_, {}, {}, flow);
    doppler.spectrum(flow, {}, power);
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

/// The gate is held once, and later spectra follow the flow.
TEST_F(Spectral, SpectraFollowTheFlowInAHeldGate) {
  BloodTube tube;
  tube.label = kVein;
  for (const double along_mm : {-60.0, 60.0})
    tube.course.push_back({Vec3{0, 0, 20} + direction() * along_mm, direction(), kRadius_mm, 1});
  BloodFlow flow{{tube}};
  SpectralDoppler doppler(probe_, settings_, gate_);
  doppler.hold(*scene_, {}, {}, flow);
  std::vector<double> power;
  for (const double speed_mmps : {200.0, -300.0, 450.0}) {
    flow.tubes[0].profile_mmps.fill(speed_mmps);
    doppler.spectrum(flow, {}, power);
    EXPECT_NEAR(peakVelocity_mmps(power), speed_mmps, 15);
  }
}

TEST_F(Spectral, ThePlaceOfTheGateIsOnItsScanline) {
  gate_.across = 0.5, gate_.range_mm = 20, gate_.gate_mm = 4;
  const GatePlace straight = gatePlace(probe_, settings_, gate_);
  EXPECT_NEAR(straight.middle_mm.x, 0, 1e-9);
  EXPECT_NEAR(straight.middle_mm.z, 20, 1e-9);
  EXPECT_NEAR(norm(straight.far_mm - straight.near_mm), 4, 1e-9);
  gate_.steering_deg = 15;
  EXPECT_NEAR(gatePlace(probe_, settings_, gate_).middle_mm.x, 20 * std::sin(15 * std::numbers::pi / 180), 1e-6);
  EXPECT_TRUE(validate(spectralSettingsFor(probe_, settings_), probe_, settings_));
}

/// A shift moves the line of a velocity down, and the axis with it.
TEST_F(Spectral, TheBaselineShiftsSpectrumAndAxisAlike) {
  std::vector<double> spectrum(kSpectrumBins);
  spectrum[160] = 1e6;
  for (const double baseline : {0.0, 0.25, -0.25, 0.45}) {
    gate_.baseline = baseline;
    std::array<std::uint8_t, kSpectrumBins> gray{};
    displaySpectrum(spectrum, gate_, 1, 0, gray);
    const auto row = double(std::ranges::max_element(gray) - gray.begin());
    EXPECT_NEAR(rowVelocity_mmps(gate_, row), binVelocity_mmps(gate_, 160), 1e-6) << baseline;
  }
}

/// Frequency of the strongest component, by comparing all of them.
double loudest_Hz(const std::vector<float>& sound, int rate_Hz) {
  double best = 0, found = 0;
  for (double f = 50; f < 2400; f += 25) {
    double re = 0, im = 0;
    for (std::size_t i = 0; i < sound.size(); ++i) {
      const double turn = 2 * std::numbers::pi * f * double(i) / rate_Hz;
      re += sound[i] * std::cos(turn), im += sound[i] * std::sin(turn);
    }
    if (re * re + im * im > best) best = re * re + im * im, found = f;
  }
  return found;
}

TEST_F(Spectral, TheSoundHasTheDopplerFrequencyAndTheRate) {
  constexpr int kRate_Hz = 48000;
  for (const int bin : {168, 88}) {
    std::vector<double> spectrum(kSpectrumBins);
    spectrum[bin] = 1e5;
    DopplerSound sound(gate_.prf_Hz, kRate_Hz, 7);
    std::vector<float> samples;
    for (int column = 0; column < 100; ++column) sound.append(spectrum, 0, 0.005, samples);
    EXPECT_NEAR(double(samples.size()), 0.5 * kRate_Hz, 1);
    EXPECT_NEAR(loudest_Hz(samples, kRate_Hz), 40 * gate_.prf_Hz / kSpectrumBins, 60);
    for (const float sample : samples) ASSERT_LE(std::abs(sample), 1);
  }
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
