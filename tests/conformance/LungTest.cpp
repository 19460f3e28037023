#include "conformance/Measure.h"
#include "conformance/Rig.h"

#include <algorithm>
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
    AcousticTable table = plainTable();
    table.tissues[kAirway].impedance_MRayl = 0.0004;
    table.tissues[kAirway].echogenicity_dB = -60;
    table.tissues[kAirway].gas = true;
    scene_ = sceneOf(paint(gridOver({-70, -8, -4}, {70, 8, 44}, 1),
                           [](Vec3 p) {
                             const bool isGas = p.z > kPleura_mm && (std::abs(p.x) > 24 || std::abs(p.x) < 5);
                             return isGas ? kAirway : kMuscle;
                           }),
                     table, {{-65, -6, -2}, {65, 6, 40}});
  }
  EnvelopeFrame at(double x_mm, double slide_mm, const std::string& engine) const {
    Transform pose;
    pose.offset = {x_mm, 0, 0};
    PlaneDisplacement displacement;
    displacement.lungSlide_mm = slide_mm;
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
}

}  // namespace
}  // namespace insonate::test
