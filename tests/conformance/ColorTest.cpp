#include "conformance/Rig.h"

#include <insonate/ultrasound/ColorDisplay.h>
#include <insonate/ultrasound/ColorDoppler.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace insonate::test {
namespace {

/// A straight tube of blood through the depth of 20 mm in the image plane, at an angle to the beam, in even tissue.
/// The probe frame is the patient frame.
struct TubeRig {
  double radius_mm = 4, angle_deg = 60;
  double middle_mm = 20;

  Vec3 direction() const {
    const double angle = angle_deg * std::numbers::pi / 180;
    return {std::sin(angle), 0, -std::cos(angle)};  // toward the probe
  }
  double offAxis_mm(Vec3 p) const {
    const Vec3 from = p - Vec3{0, 0, middle_mm};
    return norm(from - direction() * dot(from, direction()));
  }
  ScenePtr scene(const Probe& probe, const ImagingSettings& settings) const {
    AcousticTable table = plainTable();
    table.tissues[kVein].echogenicity_dB = -20;
    return sceneAround(probe, settings, 0.7, table,
                       [&](Vec3 p) { return offAxis_mm(p) < radius_mm ? kVein : kSoftTissue; });
  }
  /// Plug flow unless parabolic: the mean velocity is the velocity at every point.
  BloodFlow flow(double speed_mmps, bool parabolic = false) const {
    BloodTube tube;
    tube.label = kVein;
    for (const double along_mm : {-60.0, 0.0, 60.0})
      tube.course.push_back({Vec3{0, 0, middle_mm} + direction() * along_mm, direction(), radius_mm, 1});
    for (int i = 0; i < BloodTube::kProfile; ++i) {
      const double x = double(i) / (BloodTube::kProfile - 1);
      tube.profile_mmps[i] = speed_mmps * (parabolic ? 1 - x * x : 1);
    }
    return {{tube}};
  }
};

class Color : public testing::TestWithParam<std::string> {
 protected:
  /// Skips where this computer lacks what the engine needs, such as OpenGL.
  void SetUp() override {
    if (auto doppler = makeColorDoppler(GetParam()); !doppler) GTEST_SKIP() << doppler.error().message;
  }
  Color() {
    settings_ = silentSettings(probe_, 128, 500, 3);
    color_ = colorSettingsFor(probe_, settings_);
    color_.near_mm = 10, color_.far_mm = 30;
    color_.wallFilter_Hz = 50;
  }
  ColorFrame render(const AcousticScene& scene, const ColorMotion& motion, const Transform& pose = {},
                    const PlaneDisplacement& displacement = {}) const {
    auto doppler = makeColorDoppler(GetParam());
    (*doppler)->prepare(probe_, settings_, color_);
    ColorFrame frame;
    (*doppler)->render(scene, pose, displacement, motion, frame);
    EXPECT_EQ((*doppler)->name(), GetParam());
    return frame;
  }
  /// Velocity toward the probe in the middle of the box, from the exact autocorrelation.
  double middleVelocity_mmps(const ColorFrame& frame) const {
    const std::size_t at = frame.at(frame.lines / 2, frame.gates / 2);
    return std::atan2(frame.lagOneIm[at], frame.lagOneRe[at]) / std::numbers::pi * nyquistVelocity_mmps(color_);
  }

  Probe probe_ = probeNamed("linear");
  ImagingSettings settings_;
  ColorSettings color_;
};
INSTANTIATE_TEST_SUITE_P(Engines, Color, testing::ValuesIn(colorDopplerNames()), engineTestName);

TEST_P(Color, VelocityIsTheComponentAlongTheBeamWithinThreePercent) {
  for (const double angle_deg : {30.0, 45.0, 60.0, 70.0}) {
    const TubeRig rig{.angle_deg = angle_deg};
    const auto scene = rig.scene(probe_, settings_);
    const BloodFlow flow = rig.flow(200);
    const double expected = 200 * std::cos(angle_deg * std::numbers::pi / 180);
    EXPECT_NEAR(middleVelocity_mmps(render(*scene, {.blood = &flow})), expected, 0.03 * expected) << angle_deg;
  }
}

TEST_P(Color, SteeringChangesTheAngle) {
  const TubeRig rig{.angle_deg = 90};
  const auto scene = rig.scene(probe_, settings_);
  const BloodFlow flow = rig.flow(200);
  EXPECT_NEAR(middleVelocity_mmps(render(*scene, {.blood = &flow})), 0, 3);
  color_.steering_deg = 20;
  const double expected = -200 * std::sin(20 * std::numbers::pi / 180);
  EXPECT_NEAR(middleVelocity_mmps(render(*scene, {.blood = &flow})), expected, 3);
}

TEST_P(Color, AliasesAtTheNyquistVelocity) {
  const TubeRig rig{.angle_deg = 0.001};
  const auto scene = rig.scene(probe_, settings_);
  const double nyquist = nyquistVelocity_mmps(color_);
  EXPECT_NEAR(nyquist, 1540e3 * color_.prf_Hz / (4 * color_.frequency_MHz * 1e6), 1e-9);
  for (const double share : {0.97, 1.03, 1.5}) {
    const BloodFlow flow = rig.flow(share * nyquist);
    const double expected = (share > 1 ? share - 2 : share) * nyquist;
    EXPECT_NEAR(middleVelocity_mmps(render(*scene, {.blood = &flow})), expected, 0.01 * nyquist) << share;
  }
}

TEST_P(Color, ShowsNothingWhereBloodIsStillOrAbsent) {
  const TubeRig rig;
  const auto scene = rig.scene(probe_, settings_);
  const BloodFlow still = rig.flow(0);
  for (const BloodFlow* blood : {static_cast<const BloodFlow*>(nullptr), &still})
    for (const float power : render(*scene, {.blood = blood}).power) EXPECT_LT(power, 1e-6);
}

TEST_P(Color, AMovingProbeCausesFlashThatTheWallFilterReduces) {
  const TubeRig rig;
  const auto scene = rig.scene(probe_, settings_);
  const auto largest = [&](double wallFilter_Hz) {
    color_.wallFilter_Hz = wallFilter_Hz;
    return std::ranges::max(render(*scene, {.tissue_mmps = {0, 0, -20}}).power);
  };
  const float passed = largest(50), stopped = largest(1000);
  EXPECT_GT(passed, 1000);
  EXPECT_LT(stopped, 1);
}

TEST_P(Color, SmallVesselsBloomByTheWidthOfTheSampleVolume) {
  const TubeRig rig{.radius_mm = 4, .angle_deg = 60};
  const auto scene = rig.scene(probe_, settings_);
  const BloodFlow flow = rig.flow(200);
  const ColorFrame frame = render(*scene, {.blood = &flow});
  // Across the tube, the power falls to half at the wall and to a hundredth within a millimeter.
  const double gate_mm = 20.0 / frame.gates, wall_mm = rig.radius_mm / std::sin(60 * std::numbers::pi / 180);
  const int line = frame.lines / 2;
  const float inside = frame.power[frame.at(line, frame.gates / 2)];
  const auto powerAt = [&](double range_mm) {
    const double gate = (range_mm - 10) / gate_mm - 0.5;
    const int low = static_cast<int>(gate);
    const double t = gate - low;
    return ((1 - t) * frame.power[frame.at(line, low)] + t * frame.power[frame.at(line, low + 1)]) / inside;
  };
  // The middle scanline passes half its width beside the middle of the tube, so that both walls are averaged; beside
  // the plane, the round tube is narrower.
  EXPECT_NEAR((powerAt(20 + wall_mm) + powerAt(20 - wall_mm)) / 2, 0.45, 0.1);
  EXPECT_LT(powerAt(20 + wall_mm + 1.2), 0.01);
  EXPECT_LT(powerAt(20 - wall_mm - 1.2), 0.01);
}

TEST_P(Color, MovesWithTheDisplacedTissue) {
  const TubeRig rig{.angle_deg = 60};
  const auto scene = rig.scene(probe_, settings_);
  const BloodFlow flow = rig.flow(200);
  const ColorFrame still = render(*scene, {.blood = &flow});
  const PlaneDisplacement raised =
      displacementOver(probe_, settings_, 1, [](double, double) { return shiftBy(0, 3); });  // shown 3 mm higher
  const ColorFrame moved = render(*scene, {.blood = &flow}, {}, raised);
  const double gate_mm = 20.0 / still.gates;
  const auto center_mm = [&](const ColorFrame& frame) {
    double sum = 0, weight = 0;
    for (int g = 0; g < frame.gates; ++g) {
      const double power = frame.power[frame.at(frame.lines / 2, g)];
      sum += power * (10 + (g + 0.5) * gate_mm), weight += power;
    }
    return sum / weight;
  };
  EXPECT_NEAR(center_mm(still) - center_mm(moved), 3, 0.1);
}

TEST_P(Color, AttenuationAndBoneWeakenTheEchoes) {
  settings_.effects.attenuation = settings_.effects.transmission = true;
  const TubeRig rig;
  AcousticTable table = plainTable();
  table.tissues[kSoftTissue].attenuation_dBpcmMHz = 0.5;
  table.tissues[kBone].impedance_MRayl = 7;
  const BloodFlow flow = rig.flow(200);
  const auto powerOf = [&](const AcousticTable& of, bool bone) {
    const auto scene = sceneAround(probe_, settings_, 0.7, of, [&](Vec3 p) {
      if (bone && p.z > 6 && p.z < 9) return kBone;
      return rig.offAxis_mm(p) < rig.radius_mm ? kVein : kSoftTissue;
    });
    const ColorFrame frame = render(*scene, {.blood = &flow});
    return frame.power[frame.at(frame.lines / 2, frame.gates / 2)];
  };
  const float free = powerOf(plainTable(), false);
  const double path_cm = (20 - rig.radius_mm / std::sin(std::numbers::pi / 3)) / 10;
  EXPECT_NEAR(10 * std::log10(powerOf(table, false) / free), -2 * 0.5 * color_.frequency_MHz * path_cm, 0.7);
  EXPECT_LT(powerOf(table, true), 0.25 * powerOf(table, false));  // two boundaries, (1 - R^2)^2 each
}

TEST_P(Color, AgreesWithTheReference) {
  settings_.conformingContact = true;
  const Probe probes[] = {probeNamed("linear"), probeNamed("curvilinear")};
  for (const Probe& probe : probes) {
    probe_ = probe;
    settings_ = silentSettings(probe_, 128, 500, 3);
    settings_.effects.attenuation = settings_.effects.transmission = true;
    color_ = colorSettingsFor(probe_, settings_);
    color_.near_mm = 8, color_.far_mm = 32;
    color_.steering_deg = 10;
    const TubeRig rig{.radius_mm = 3.3, .angle_deg = 65};
    AcousticTable table = *loadAcousticTable("neck");
    const auto scene = sceneAround(
        probe_, settings_, 0.7, table,
        [&](Vec3 p) {
          if (p.z < 1 + 0.05 * p.x) return kBackground;
          if (p.x > 9 && p.z > 12) return kBone;
          return rig.offAxis_mm(p) < rig.radius_mm ? kVein : kMuscle;
        },
        {}, 4);
    const BloodFlow flow = rig.flow(400, true);
    const PlaneDisplacement swirl =
        displacementOver(probe_, settings_, 1, [](double x, double z) { return swirlAt(x, z, 2, 18, 8, 12); });
    const ColorMotion motion{.blood = &flow, .tissue_mmps = {3, 0, -9}};
    auto truth = makeColorDoppler("reference");
    (*truth)->prepare(probe_, settings_, color_);
    ColorFrame exact;
    (*truth)->render(*scene, {}, swirl, motion, exact);
    const ColorFrame frame = render(*scene, motion, {}, swirl);
    double error = 0, sum = 0;
    for (std::size_t i = 0; i < exact.power.size(); ++i) {
      const double dr = frame.lagOneRe[i] - exact.lagOneRe[i], di = frame.lagOneIm[i] - exact.lagOneIm[i],
                   dp = frame.power[i] - exact.power[i];
      error += dr * dr + di * di + dp * dp;
      sum += 2 * exact.power[i] * exact.power[i];
    }
    EXPECT_GT(sum, 0);
    EXPECT_LT(std::sqrt(error / sum), 0.005) << probe.name;
    RecordProperty("relative_error_" + probe.name, std::to_string(std::sqrt(error / sum)));
  }
}

}  // namespace
}  // namespace insonate::test
