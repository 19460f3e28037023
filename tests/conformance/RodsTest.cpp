#include "conformance/Measure.h"
#include "conformance/Rig.h"

#include <insonate/ultrasound/PointSpread.h>

#include <cmath>
#include <numbers>

namespace insonate::test {
namespace {

class Rods : public EngineTest {};
INSONATE_FOR_ALL_ENGINES(Rods);

constexpr double kFocus_mm = 20;

/// A rod alone: nothing scatters, nothing is lost.
struct Bench {
  Probe probe = probeNamed("linear");
  ImagingSettings settings = silentSettings(probe, 256, 1000, 3);
  ScenePtr scene;

  Bench() {
    settings.effects.reflection = true;
    scene = evenScene(probe, settings);
  }
  BeamGrid grid() const { return {probe, settings}; }
  EnvelopeFrame with(const std::string& engine, const FlexibleRod& rod) const {
    return renderWithRods(engine, probe, settings, *scene, {rod});
  }
};

FlexibleRod rodAlong(Vec3 middle_mm, Vec3 direction, RodMaterial material = RodMaterial::SteelCoil) {
  FlexibleRod rod;
  rod.material = material;
  if (material == RodMaterial::Polymer) rod.radius_mm = 1.165, rod.innerRadius_mm = 0.85;
  const Vec3 along = normalized(direction);
  for (double s = -40; s <= 40; s += 2) rod.nodes_mm.push_back(middle_mm + along * s);
  return rod;
}

double brightest(const EnvelopeFrame& frame, int line) {
  return peakOf(scanline(frame, line)).value;
}

TEST_P(Rods, WireAlongTheImageIsALineOnItsNearSide) {
  const Bench bench;
  const EnvelopeFrame frame = bench.with(GetParam(), rodAlong({0, 0, kFocus_mm + 0.405}, {1, 0, 0}));
  const BeamGrid grid = bench.grid();
  double first = 0;
  for (const int line : {40, 90, 128, 170, 220}) {
    const Peak peak = peakOf(scanline(frame, line));
    EXPECT_NEAR(grid.range_mm(peak.index), kFocus_mm, 0.05) << line;
    if (first == 0) first = peak.value;
    EXPECT_NEAR(peak.value / first, 1, 0.05) << line;
  }
  record("wire_dB", decibel(first));
}

TEST_P(Rods, WireIsWeakerThanANeedleByTheWidthOfItsStrip) {
  const Bench bench;
  const Needle needle = needleAt({12, 0, kFocus_mm + 0.635}, {1, 0, 0});
  const double shaft = brightest(render(bench.probe, bench.settings, bench.scene, {}, {}, needle), 128);
  const double wire = brightest(bench.with(GetParam(), rodAlong({0, 0, kFocus_mm + 0.405}, {1, 0, 0})), 128);
  EXPECT_NEAR(wire / shaft, std::sqrt(0.405 / 0.635), 0.02);
}

TEST_P(Rods, WireStaysVisibleWhereANeedleIsLost) {
  const Bench bench;
  const auto tilted = [&](double angle_deg) {
    const double angle = angle_deg * std::numbers::pi / 180;
    return brightest(bench.with(GetParam(), rodAlong({0, 0, kFocus_mm}, {std::cos(angle), 0, std::sin(angle)})), 128);
  };
  const double square = tilted(0);
  EXPECT_NEAR(decibel(square / tilted(30)), 8, 2);
  EXPECT_LT(decibel(square / tilted(60)), 20);
}

TEST_P(Rods, WireAcrossTheImageIsASpotWithATail) {
  Bench bench;
  bench.settings.effects.reverberation = true;
  const EnvelopeFrame frame = bench.with(GetParam(), rodAlong({3, 0, kFocus_mm + 0.405}, {0, 1, 0}));
  const BeamGrid grid = bench.grid();
  const int line = int(std::lround(grid.locate(3, kFocus_mm).scanline));
  const Peak down = peakOf(scanline(frame, line));
  EXPECT_NEAR(grid.range_mm(down.index), kFocus_mm, 0.1);
  EXPECT_NEAR(peakOf(acrossLines(frame, int(std::lround(down.index)))).index, line, 1);
  const auto all = scanline(frame, line);
  const auto meanAt = [&](double from_mm, double to_mm) {
    double sum = 0;
    const int low = int(grid.sampleAt(from_mm)), high = int(grid.sampleAt(to_mm));
    for (int i = low; i < high; ++i) sum += all[i];
    return sum / (high - low);
  };
  const double near = meanAt(21.2, 22.3), far = meanAt(25.2, 26.3);
  EXPECT_LT(near, 0.3 * down.value);
  EXPECT_GT(near, 0.01 * down.value);
  EXPECT_NEAR(decibel(near / far), 4 * 5, 3);
  EXPECT_EQ(meanAt(34, 38), 0) << "the tail ends";
  EXPECT_EQ(meanAt(5, 18), 0) << "nothing in front of it";
}

TEST_P(Rods, CatheterIsADoubleLineAroundADarkLumen) {
  const Bench bench;
  const EnvelopeFrame frame = bench.with(GetParam(), rodAlong({0, 0, kFocus_mm}, {1, 0, 0}, RodMaterial::Polymer));
  const BeamGrid grid = bench.grid();
  const auto all = scanline(frame, 128);
  const auto peakNear = [&](double depth_mm) {
    const int low = int(grid.sampleAt(depth_mm - 0.4)), high = int(grid.sampleAt(depth_mm + 0.4));
    return peakOf(std::span(all).subspan(low, high - low)).value;
  };
  const double nearWall = peakNear(kFocus_mm - 1), farWall = peakNear(kFocus_mm + 1);
  EXPECT_NEAR(farWall / nearWall, 0.87, 0.1);
  const double lumen = all[int(grid.sampleAt(kFocus_mm))];
  EXPECT_LT(lumen, 0.05 * nearWall);
}

TEST_P(Rods, MoveWithTheTissue) {
  const Bench bench;
  // A displacement from where tissue is displayed to where it rests.
  const PlaneDisplacement shifted =
      displacementOver(bench.probe, bench.settings, 1, [](double, double) { return shiftBy(2, -3); });
  const EnvelopeFrame there = renderWithRods(GetParam(), bench.probe, bench.settings, *bench.scene,
                                             {rodAlong({0, 0, kFocus_mm}, {1, 0, 0.2})}, shifted);
  const EnvelopeFrame expected = bench.with(GetParam(), rodAlong({-2, 0, kFocus_mm + 3}, {1, 0, 0.2}));
  EXPECT_LT(relativeError(there, expected), 0.02);
}

TEST_P(Rods, ShadowLiesBehindTheWireOnly) {
  Bench bench;
  bench.settings = speckleSettings(bench.probe, 256, 1000, 3);
  const BeamGrid grid = bench.grid();
  const EnvelopeFrame without = render(bench.probe, bench.settings, bench.scene);
  bench.settings.effects.transmission = true;
  const EnvelopeFrame frame = bench.with(GetParam(), rodAlong({0, 0, 15}, {0, 1, 0}));
  const auto part = [&](const EnvelopeFrame& of, double left_mm, double right_mm, double top_mm, double bottom_mm) {
    return valuesIn(of, {int(grid.sampleAt(top_mm)), int(grid.sampleAt(bottom_mm)),
                         int(grid.locate(left_mm, 10).scanline), int(grid.locate(right_mm, 10).scanline)});
  };
  const double left = rms(part(frame, -0.4, 0.4, 16, 30)) / rms(part(without, -0.4, 0.4, 16, 30));
  EXPECT_GT(left, 0.6);
  EXPECT_LT(left, 0.95);
  const EnvelopeFrame along = bench.with(GetParam(), rodAlong({0, 0, 15}, {1, 0, 0}));
  const double leftAlong = rms(part(along, -10, 10, 16, 30)) / rms(part(without, -10, 10, 16, 30));
  EXPECT_GT(leftAlong, 0.4);
  EXPECT_LT(leftAlong, 0.8);
  EXPECT_EQ(part(frame, -15, 15, 1, 13), part(without, -15, 15, 1, 13));
  EXPECT_EQ(part(frame, 8, 15, 16, 38), part(without, 8, 15, 16, 38));
}

TEST_P(Rods, OutOfReachOrNoneChangeNothing) {
  const Probe probe = probeNamed("linear");
  ImagingSettings settings = settingsFor(probe);
  settings.scanlines = 64, settings.samples = 256;
  const ScenePtr scene = evenScene(probe, settings);
  const EnvelopeFrame without = render(probe, settings, scene);
  for (const FlexibleRod& away :
       {rodAlong({0, 12, 20}, {1, 0, 0}), rodAlong({0, 0, 300}, {1, 0, 0}), rodAlong({70, 0, 20}, {0, 0, 1})})
    EXPECT_TRUE(identical(renderWithRods(GetParam(), probe, settings, *scene, {away}), without));
  EXPECT_FALSE(
      identical(renderWithRods(GetParam(), probe, settings, *scene, {rodAlong({0, 0, 20}, {1, 0, 0})}), without));
}

TEST_P(Rods, NextFrameWithoutThemIsClean) {
  const Probe probe = probeNamed("linear");
  ImagingSettings settings = settingsFor(probe);
  settings.scanlines = 64, settings.samples = 256;
  const ScenePtr scene = evenScene(probe, settings);
  auto engine = makeEngine(GetParam()).value();
  engine->prepare(probe, settings);
  EnvelopeFrame before, during, after;
  engine->render(*scene, {}, before);
  const std::vector<FlexibleRod> rods{rodAlong({0, 0, 20}, {1, 0, 0.3}),
                                      rodAlong({4, 0, 15}, {0, 1, 0}, RodMaterial::Polymer)};
  engine->render(*scene, {}, {}, {nullptr, rods}, during);
  engine->render(*scene, {}, after);
  EXPECT_FALSE(identical(before, during));
  EXPECT_TRUE(identical(before, after));
}

TEST_P(Rods, AgreeWithTheReference) {
  const Probe probe = probeNamed("linear");
  ImagingSettings settings = settingsFor(probe);
  settings.scanlines = 96, settings.samples = 512;
  const ScenePtr scene = evenScene(probe, settings);
  const std::vector<FlexibleRod> rods{rodAlong({0, 0, 20}, {1, 0.02, 0.3}),
                                      rodAlong({4, 0, 12}, {0.1, 1, 0}, RodMaterial::Polymer)};
  const Needle needle = needleAt({-2, 0, 15}, {1, 0, 1});
  const EnvelopeFrame expected = renderWithRods("reference", probe, settings, *scene, rods, {}, &needle);
  EXPECT_LT(relativeError(renderWithRods(GetParam(), probe, settings, *scene, rods, {}, &needle), expected), 0.005);
}

TEST(RodCheck, RefusesWhatIsNoRod) {
  FlexibleRod rod = rodAlong({0, 0, 20}, {1, 0, 0});
  EXPECT_TRUE(validate(rod));
  rod.radius_mm = 5;
  EXPECT_NE(validate(rod).error().message.find("radius"), std::string::npos);
  rod.radius_mm = 0.4, rod.nodes_mm.resize(1);
  EXPECT_NE(validate(rod).error().message.find("nodes"), std::string::npos);
  rod.nodes_mm = {{0, 0, 0}, {NAN, 0, 0}};
  EXPECT_NE(validate(rod).error().message.find("finite"), std::string::npos);
}

}  // namespace
}  // namespace insonate::test
