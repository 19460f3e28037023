#include "conformance/Measure.h"
#include "conformance/Rig.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace insonate::test {
namespace {

constexpr double kPleura_mm = 15;

/// Muscle over two lungs, with the airway between them. The probe frame is the patient frame, moved along x.
class Lung : public testing::TestWithParam<std::string> {
 protected:
  Lung() {
    settings_ = silentSettings(probe_, 96, 400, 1);
    settings_.depth_mm = 30;
    settings_.effects.scattering = settings_.effects.speckle = true;
    settings_.effects.reflection = settings_.effects.reverberation = true;
    scene_ = sceneBelow(-100);
  }
  /// The skin lies at the depth `skin_mm` below the face.
  static ScenePtr sceneBelow(double skin_mm) {
    AcousticTable table = plainTable();
    table.tissues[kAirway].impedance_MRayl = 0.0004;
    table.tissues[kAirway].echogenicity_dB = -60;
    table.tissues[kAirway].gas = true;
    return sceneOf(paint(gridOver({-70, -8, -4}, {70, 8, 44}, 1),
                         [skin_mm](Vec3 p) {
                           const bool isGas = p.z > kPleura_mm && (std::abs(p.x) > 24 || std::abs(p.x) < 5);
                           return p.z < skin_mm ? kBackground : isGas ? kAirway : kMuscle;
                         }),
                   table, {{-65, -6, -2}, {65, 6, 40}});
  }
  EnvelopeFrame at(double x_mm, double slide_mm, const std::string& engine,
                   const std::array<double, 2>& detached_mm = {}) const {
    Transform pose;
    pose.offset = {x_mm, 0, 0};
    PlaneDisplacement displacement;
    displacement.lung = {slide_mm, detached_mm};
    return renderWith(engine, probe_, settings_, *scene_, pose, displacement);
  }
  /// Share of the amplitudes between two depths that differ by more than a tenth of their mean.
  double changed(const EnvelopeFrame& a, const EnvelopeFrame& b, double from_mm, double to_mm) const {
    const int first = int(from_mm / settings_.depth_mm * a.samples), last = int(to_mm / settings_.depth_mm * a.samples);
    double mean = 0, count = 0, different = 0;
    const auto each = [&](const auto& use) {
      for (int sample = first; sample < last; ++sample)
        for (int line = 8; line < a.scanlines - 8; ++line) {
          const std::size_t i = std::size_t(sample) * a.scanlines + line;
          use(a.amplitude[i], b.amplitude[i]);
        }
    };
    each([&](float x, float) { mean += x, count += 1; });
    each([&](float x, float y) { different += std::abs(x - y) > 0.1 * mean / count; });
    return different / count;
  }

  Probe probe_ = probeNamed("linear");
  ImagingSettings settings_;
  ScenePtr scene_;
};
INSTANTIATE_TEST_SUITE_P(Engines, Lung, testing::ValuesIn(engineNames()), engineTestName);

TEST_P(Lung, EchoesBelowThePleuraSlideAndTheChestWallStays) {
  const EnvelopeFrame rest = at(45, 0, GetParam()), slid = at(45, 3, GetParam());
  EXPECT_EQ(changed(rest, slid, 1, kPleura_mm - 1), 0);
  EXPECT_GT(changed(rest, slid, kPleura_mm + 1.5, kPleura_mm + 6), 0.15);
  EXPECT_LT(changed(rest, at(45, 0.01, GetParam()), kPleura_mm + 1.5, kPleura_mm + 6), 0.1) << "a small slide";
}

TEST_P(Lung, TheAirwayDoesNotSlide) {
  EXPECT_EQ(changed(at(0, 0, GetParam()), at(0, 3, GetParam()), 1, 25), 0);
}

TEST_P(Lung, ASlidLungAgreesWithTheReference) {
  EXPECT_LT(relativeError(at(45, 2.3, GetParam()), at(45, 2.3, "reference")), 0.005);
  EXPECT_LT(relativeError(at(45, 2.3, GetParam(), {0, 45}), at(45, 2.3, "reference", {0, 45})), 0.005);
}

/// The lung point is where the lung begins to slide, away from the trachea.
TEST_P(Lung, APneumothoraxStopsOneLungUpToTheLungPoint) {
  const auto isMoving = [&](double x_mm, const std::array<double, 2>& detached_mm) {
    return changed(at(x_mm, 0, GetParam(), detached_mm), at(x_mm, 3, GetParam(), detached_mm), kPleura_mm + 1.5,
                   kPleura_mm + 6);
  };
  EXPECT_EQ(isMoving(45, {0, 90}), 0);
  EXPECT_EQ(isMoving(-45, {90, 0}), 0);
  EXPECT_GT(isMoving(-45, {0, 90}), 0.15) << "the lung of the other side";
  EXPECT_GT(isMoving(45, {90, 0}), 0.15);
  const double whole = isMoving(45, {}), beyondPoint = isMoving(45, {0, 45});
  EXPECT_NEAR(beyondPoint / whole, 0.5, 0.15) << "half of the image is beyond the lung point";
}

/// Spatial compounding draws the skin to the face by a displacement of its own.
TEST_P(Lung, ACompoundedLungSlides) {
  ImagingSettings settings = settings_;
  settings.compoundingAngles = 3, settings.conformingContact = true;
  const auto engine = makeEngineFor(GetParam(), probe_, settings);
  ASSERT_TRUE(engine);
  (*engine)->prepare(probe_, settings);
  const ScenePtr belowSkin = sceneBelow(1);
  Transform pose;
  pose.offset = {45, 0, 0};
  EnvelopeFrame rest, slid;
  PlaneDisplacement displacement;
  (*engine)->render(*belowSkin, pose, displacement, rest);
  displacement.lung.slide_mm = 3;
  (*engine)->render(*belowSkin, pose, displacement, slid);
  EXPECT_GT(changed(rest, slid, kPleura_mm + 1.5, kPleura_mm + 6), 0.1);
}

}  // namespace
}  // namespace insonate::test
