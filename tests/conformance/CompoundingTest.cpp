#include "conformance/Measure.h"
#include "conformance/Rig.h"

#include <cmath>

namespace insonate::test {
namespace {

class Compounding : public EngineTest {};
INSONATE_FOR_ALL_ENGINES(Compounding);

EnvelopeFrame compounded(const std::string& name, const Probe& probe, const ImagingSettings& settings,
                         const AcousticScene& scene) {
  auto engine = makeEngineFor(name, probe, settings);
  if (!engine) throw std::runtime_error(engine.error().message);
  EnvelopeFrame frame;
  (*engine)->prepare(probe, settings);
  (*engine)->render(scene, {}, {}, nullptr, frame);
  return frame;
}

Region regionFor(const Probe& probe, ImagingSettings settings) {
  settings.compoundingAngles = 5;
  return regionAround(probe, settings, {}, 1);
}

/// A steered frame shows a point where it is, by its own grid.
TEST_P(Compounding, SteeredScanlinesShowAPointWhereItIs) {
  const Probe probe = probeNamed("linear");
  for (const double steering_deg : {-12.0, 7.0, 20.0}) {
    ImagingSettings settings = silentSettings(probe, 256, 1000, 1);
    settings.steering_deg = steering_deg;
    const Vec3 point{3, 0, 25};
    const Region region = regionAround(probe, settings, {}, 1);
    const ScenePtr scene = sceneOf(paint(alignedGridOver(region, 5), [](Vec3) { return kSoftTissue; }), plainTable(),
                                   region, {{point, 1}});
    const EnvelopeFrame frame = renderWith(GetParam(), probe, settings, *scene);
    const std::vector<double> all = valuesIn(frame, wholeFrame(frame));
    const auto top = std::size_t(std::max_element(all.begin(), all.end()) - all.begin());
    const int sample = int(top) / frame.scanlines, line = int(top) % frame.scanlines;
    const BeamGrid grid(probe, settings);
    const Vec3 found = grid.origin(line) + grid.direction(line) * grid.range_mm(sample);
    EXPECT_NEAR(found.x, point.x, 0.15) << steering_deg;
    EXPECT_NEAR(found.z, point.z, 0.1) << steering_deg;
  }
}

TEST_P(Compounding, LeavesAPointWhereItIs) {
  const Probe probe = probeNamed("linear");
  ImagingSettings settings = silentSettings(probe, 256, 1000, 1);
  const Region region = regionFor(probe, settings);
  const Vec3 point{2, 0, 20};
  const ScenePtr scene =
      sceneOf(paint(alignedGridOver(region, 5), [](Vec3) { return kSoftTissue; }), plainTable(), region, {{point, 1}});
  const BeamGrid grid(probe, settings);
  const auto at = grid.locate(point.x, point.z);
  for (const int angles : {1, 3, 5}) {
    settings.compoundingAngles = angles;
    const EnvelopeFrame frame = compounded(GetParam(), probe, settings, *scene);
    EXPECT_NEAR(peakOf(scanline(frame, int(std::lround(at.scanline)))).index, at.sample, 2) << angles;
    EXPECT_NEAR(peakOf(acrossLines(frame, int(std::lround(at.sample)))).index, at.scanline, 1) << angles;
  }
}

/// Speckle keeps its level, and angles that do not share it take some of it away.
TEST_P(Compounding, KeepsTheLevelAndSoftensSpeckle) {
  const Probe probe = probeNamed("linear");
  ImagingSettings settings = speckleSettings(probe, 256, 1000, 3);
  const Region region = regionFor(probe, settings);
  const ScenePtr scene =
      sceneOf(paint(alignedGridOver(region, 5), [](Vec3) { return kSoftTissue; }), plainTable(), region);
  const Window middle{300, 700, 80, 176};
  const std::vector<double> plain = valuesIn(compounded(GetParam(), probe, settings, *scene), middle);
  settings.compoundingAngles = 5;
  const std::vector<double> five = valuesIn(compounded(GetParam(), probe, settings, *scene), middle);
  EXPECT_NEAR(decibel(rms(five) / rms(plain)), 0, 0.7);
  EXPECT_LT(standardDeviation(five) / mean(five), 0.8 * standardDeviation(plain) / mean(plain));
}

/// Sloping skin above a wall, as at the end of a face on a round neck: each angle draws the tissue to the same place.
class ComesToTheFace {
 public:
  explicit ComesToTheFace(const std::string& engine) : engine_(engine) {
    settings.conformingContact = true;
    settings.effects.reflection = true;
    settings.compoundingAngles = 5;
    AcousticTable table = plainTable();
    table.tissues[kMuscle].impedance_MRayl = 1.7;
    scene_ = sceneAround(probe, settings, 0.7, table, [](Vec3 p) {
      return p.z < 3 + 0.25 * p.x ? kBackground : p.z < kWall_mm ? kFat : kMuscle;
    });
  }

  /// Depth and width of the deepest line below the face, at a lateral position.
  Peak lineAt(double x_mm, int angles, const std::optional<Needle>& needle = {}) {
    settings.compoundingAngles = angles;
    auto engine = *makeEngineFor(engine_, probe, settings);
    engine->prepare(probe, settings);
    EnvelopeFrame frame;
    engine->render(*scene_, {}, {}, needle ? &*needle : nullptr, frame);
    const BeamGrid grid(probe, settings);
    const int below = int(grid.sampleAt(5));
    const std::vector<double> all = scanline(frame, int(std::lround(grid.locate(x_mm, 5).scanline)));
    Peak peak = peakOf(std::span(all).subspan(below));
    peak.index = grid.range_mm(below + peak.index);
    peak.fwhm *= grid.step_mm();
    return peak;
  }

  static constexpr double kWall_mm = 16;
  Probe probe = probeNamed("linear");
  ImagingSettings settings = silentSettings(probe, 256, 1000, 1);

 private:
  std::string engine_;
  ScenePtr scene_;
};

TEST_P(Compounding, ShowsAWallBelowAGapOnce) {
  ComesToTheFace skin(GetParam());
  for (const double x_mm : {0.0, 6.0, 10.0}) {
    const Peak one = skin.lineAt(x_mm, 1), five = skin.lineAt(x_mm, 5);
    const double gap_mm = 3 + 0.25 * x_mm;
    record("width_" + std::to_string(int(x_mm)), five.fwhm / one.fwhm);
    EXPECT_NEAR(one.index + gap_mm * std::exp(-one.index / 15), ComesToTheFace::kWall_mm, 0.15) << x_mm;
    EXPECT_NEAR(five.index, one.index, 0.06) << x_mm;
    EXPECT_GT(five.fwhm, 0) << x_mm;
    EXPECT_LT(five.fwhm, 1.3 * one.fwhm) << x_mm;
  }
}

TEST_P(Compounding, ShowsANeedleBelowAGapOnce) {
  ComesToTheFace skin(GetParam());
  const Needle needle = needleAt({6, 0, 12}, {1, 0, 0});
  const Peak one = skin.lineAt(0, 1, needle), five = skin.lineAt(0, 5, needle);
  EXPECT_LT(one.index, 12 - needle.radius_mm - 1) << "drawn with the tissue";
  EXPECT_NEAR(five.index, one.index, 0.06);
  EXPECT_LT(five.fwhm, 1.5 * one.fwhm);
}

TEST_P(Compounding, LosesTheLevelOfOneAngleWhereTheSkinIsFarOff) {
  const Probe probe = probeNamed("linear");
  ImagingSettings settings = uniformSettings(probe, 128, 400, 1);
  settings.conformingContact = true;
  const Region region = regionFor(probe, settings);
  const ScenePtr scene =
      sceneOf(paint(alignedGridOver(region, 0.7), [](Vec3 p) { return p.z < 9.1 ? kBackground : kSoftTissue; }),
              plainTable(), region);
  const Window middle{150, 300, 40, 88};
  const double one = rms(valuesIn(compounded(GetParam(), probe, settings, *scene), middle));
  settings.compoundingAngles = 3;
  const double three = rms(valuesIn(compounded(GetParam(), probe, settings, *scene), middle));
  EXPECT_NEAR(one, 0.5, 0.1) << "halfway between a good contact at 6 mm and none at 12 mm";
  EXPECT_NEAR(decibel(three / one), 0, 0.5);
}

/// Behind a strip that lets nothing pass, angles see under it: the shadow closes with depth, sooner than it does for
/// the cone of one scanline's aperture.
TEST_P(Compounding, MakesShadowsCones) {
  const Probe probe = probeNamed("linear");
  ImagingSettings settings = uniformSettings(probe, 256, 800, 1);
  settings.effects.attenuation = true;
  AcousticTable table = plainTable();
  table.tissues[kBone].attenuation_dBpcmMHz = 60;
  const Region region = regionFor(probe, settings);
  const ScenePtr scene =
      sceneOf(paint(alignedGridOver(region, 0.7),
                    [](Vec3 p) { return std::abs(p.x) < 2.1 && p.z > 7 && p.z < 9.8 ? kBone : kSoftTissue; }),
              table, region);
  const BeamGrid grid(probe, settings);
  const auto shadow_mm = [&](const EnvelopeFrame& frame, double depth_mm) {
    const std::vector<double> row = acrossLines(frame, int(std::lround(grid.sampleAt(depth_mm))));
    int dark = 0;
    for (const double value : row) dark += value < 0.1;
    return dark * grid.scanlineSpacing_mm(depth_mm);
  };
  const EnvelopeFrame plain = compounded(GetParam(), probe, settings, *scene);
  EXPECT_NEAR(shadow_mm(plain, 12), 3, 0.6) << "less a penumbra of 0.6 mm either way";
  EXPECT_GT(shadow_mm(plain, 17), 1);
  settings.compoundingAngles = 3;
  const EnvelopeFrame three = compounded(GetParam(), probe, settings, *scene);
  EXPECT_GT(shadow_mm(three, 12), 2);
  EXPECT_LT(shadow_mm(three, 17), 0.5 * shadow_mm(plain, 17));
}

/// A machine sends one angle after the other. Once each has been sent from a new place, its image is that of all.
TEST_P(Compounding, AnglesInTurnCostOneFrameAndSettle) {
  const Probe probe = probeNamed("linear");
  ImagingSettings settings = speckleSettings(probe, 128, 400, 1);
  Transform beside;
  beside.offset = {1.5, 0, 0};
  const Region region = regionFor(probe, settings);
  const ScenePtr scene =
      sceneOf(paint(alignedGridOver(region, 5), [](Vec3) { return kSoftTissue; }), plainTable(), region);
  settings.compoundingAngles = 3;
  const auto make = [&](CompoundingSchedule angles) {
    auto engine = *makeEngineFor(GetParam(), probe, settings, angles);
    engine->prepare(probe, settings);
    return engine;
  };
  const auto all = make(CompoundingSchedule::AllAnglesPerFrame), inTurn = make(CompoundingSchedule::OneAnglePerFrame);
  EnvelopeFrame there, moved, frame;
  all->render(*scene, {}, there);
  all->render(*scene, beside, moved);
  inTurn->render(*scene, {}, frame);
  EXPECT_EQ(frame.amplitude, there.amplitude) << "the first frame has all angles";
  for (int n = 0; n < 2; ++n) {
    inTurn->render(*scene, beside, frame);
    EXPECT_NE(frame.amplitude, there.amplitude) << n;
    EXPECT_NE(frame.amplitude, moved.amplitude) << n;
  }
  inTurn->render(*scene, beside, frame);
  EXPECT_EQ(frame.amplitude, moved.amplitude);
}

}  // namespace
}  // namespace insonate::test
