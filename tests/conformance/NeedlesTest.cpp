#include "conformance/Measure.h"
#include "conformance/Rig.h"

#include <insonate/ultrasound/PointSpread.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace insonate::test {
namespace {

class Needles : public EngineTest {};
INSONATE_FOR_ALL_ENGINES(Needles);

constexpr double kRadius_mm = 0.635, kFocus_mm = 20;
constexpr double kPi = std::numbers::pi;

/// A needle alone: nothing scatters, nothing is lost.
struct Bench {
  Probe probe = probeNamed("linear");
  ImagingSettings settings = silentSettings(probe, 256, 1000, 3);
  ScenePtr scene;

  explicit Bench(const std::string& name = "linear") : probe(probeNamed(name)) {
    settings = silentSettings(probe, 256, 1000, 3);
    settings.effects.reflection = true;
    scene = evenScene(probe, settings);
  }
  BeamGrid grid() const { return {probe, settings}; }
};

/// Its near side at the focus, in the middle of the frame, tilted in the plane, its bevel far to the side.
Needle tilted(double angle_deg, double elevation_mm = 0) {
  const double angle = angle_deg * kPi / 180;
  const Vec3 along{std::cos(angle), 0, std::sin(angle)}, near{-std::sin(angle), 0, std::cos(angle)};
  return needleAt(Vec3{0, elevation_mm, kFocus_mm} + near * kRadius_mm + along * 12, along);
}

/// Amplitude of a point across the slice at the focus, over that in the plane, 0.1 mm apart from the plane outward: an
/// independent way to what the slice does to a needle.
std::vector<double> sliceByPoints(const Bench& bench, const std::string& engine) {
  ImagingSettings settings = silentSettings(bench.probe, 32, 1000, 1);
  const Region region = regionAround(bench.probe, settings);
  const BeamGrid grid(bench.probe, settings);
  const ScenePtr scene = sceneOf(paint(gridOver(region.low_mm, region.high_mm, 30), [](Vec3) { return kSoftTissue; }),
                                 plainTable(), region, {{grid.origin(16) + Vec3{0, 0, kFocus_mm}, 100}});
  std::vector<double> slice;
  for (int n = 0; n < 50; ++n)
    slice.push_back(largest(renderWith(engine, bench.probe, settings, *scene, moved({0, 0.1 * n, 0}))));
  const double inPlane = slice.front();
  for (double& value : slice) value /= inPlane;
  return slice;
}

double brightestOfLine(const EnvelopeFrame& frame, int line) {
  return peakOf(scanline(frame, line)).value;
}

TEST_P(Needles, SquareToTheBeamEchoAsACylinderDoes) {
  const Bench bench;
  const EnvelopeFrame frame = render(bench.probe, bench.settings, bench.scene, {}, {}, tilted(0));
  const double wavenumber = 2 * kPi / wavelength_mm(bench.settings);
  // A plane reflector of steel peaks at 58 dB; a cylinder at what a slice sees of sqrt(pi a / k).
  const std::vector<double> slice = sliceByPoints(bench, GetParam());
  const double slice_mm = 0.1 * (2 * std::reduce(slice.begin(), slice.end()) - 1);
  const double strip = std::sqrt(kPi * kRadius_mm / wavenumber) / slice_mm;
  const double expected = std::pow(10, 58 / 20.0) * (45 - 1.63) / (45 + 1.63) * strip;
  const Peak peak = peakOf(scanline(frame, 128));
  EXPECT_NEAR(peak.value / expected, 1, 0.05);
  EXPECT_NEAR(bench.grid().range_mm(peak.index), kFocus_mm, 0.05);
  record("square_dB", decibel(peak.value));
}

/// Nichols et al. 2003: from 60-76 to 5 of 100 units of gray between square and 75 degrees off: 33 dB of 60, linearly.
TEST_P(Needles, DimWithTheTiltAsPublished) {
  const Bench bench;
  double before = 0, square_dB = 0;
  for (const double angle_deg : {0.0, 15.0, 30.0, 45.0, 60.0, 75.0}) {
    const double here =
        brightestOfLine(render(bench.probe, bench.settings, bench.scene, {}, {}, tilted(angle_deg)), 128);
    record("tilt_" + std::to_string(int(angle_deg)) + "_dB", decibel(here));
    if (angle_deg == 0) {
      square_dB = decibel(here);
    } else {
      EXPECT_LT(here, before) << angle_deg;
      EXPECT_NEAR((square_dB - decibel(here)) / angle_deg, 0.44, 0.03) << angle_deg;
    }
    before = here;
  }
}

TEST_P(Needles, FadeAsTheBeamDoesWhenTheyLeaveTheSlice) {
  const Bench bench;
  const double central = brightestOfLine(render(bench.probe, bench.settings, bench.scene, {}, {}, tilted(0)), 128);
  const std::vector<double> slice = sliceByPoints(bench, GetParam());
  for (const int tenths : {2, 4, 6, 8, 10, 15, 25, 40}) {
    const double here =
        brightestOfLine(render(bench.probe, bench.settings, bench.scene, {}, {}, tilted(0, 0.1 * tenths)), 128);
    EXPECT_NEAR(here / central, slice[tenths], 0.01) << tenths;
  }
  EXPECT_EQ(brightestOfLine(render(bench.probe, bench.settings, bench.scene, {}, {}, tilted(0, 11)), 128), 0);
}

TEST_P(Needles, AcrossTheSliceAreASpotAsWideAsTheBeam) {
  const Bench bench;
  for (const double x_mm : {-8.0, 0.0, 6.5}) {
    const Needle needle = needleAt({x_mm, 30, kFocus_mm + kRadius_mm}, {0, 1, 0});
    const EnvelopeFrame frame = render(bench.probe, bench.settings, bench.scene, {}, {}, needle);
    const BeamGrid grid = bench.grid();
    const auto at = grid.locate(x_mm, kFocus_mm);
    const Peak down = peakOf(scanline(frame, int(std::lround(at.scanline))));
    const Peak across = peakOf(acrossLines(frame, int(std::lround(down.index))));
    EXPECT_NEAR(grid.range_mm(down.index), kFocus_mm, 0.1);
    EXPECT_NEAR(across.index, at.scanline, 0.5);
    // Laid on scanlines by a B-spline with an SD of half their distance.
    const double spacing_mm = grid.scanlineSpacing_mm(kFocus_mm);
    const double lateral_mm =
        std::hypot(lateralFwhm_mm(bench.probe, bench.settings, kFocus_mm), 2.3548 * 0.5 * spacing_mm);
    EXPECT_NEAR(across.fwhm * spacing_mm / lateral_mm, 1, 0.15);
    EXPECT_NEAR(down.fwhm * grid.step_mm() / axialFwhm_mm(bench.probe, bench.settings), 1, 0.25);
  }
}

TEST_P(Needles, EndAtTheirTipWhichIsBrighter) {
  const Bench bench;
  const BeamGrid grid = bench.grid();
  for (const double angle_deg : {15.0, 45.0, 60.0}) {
    const double angle = angle_deg * kPi / 180;
    const EnvelopeFrame frame = render(bench.probe, bench.settings, bench.scene, {}, {},
                                       needleAt({2, 0, 22}, {std::cos(angle), 0, std::sin(angle)}));
    const int tip = int(std::lround(grid.locate(2, 22).scanline));
    const double atTip = brightestOfLine(frame, tip - 2), shaft = brightestOfLine(frame, tip - 50);
    EXPECT_GT(atTip, 1.2 * shaft) << angle_deg;
    EXPECT_LT(brightestOfLine(frame, tip + 7), 0.02 * atTip) << angle_deg;
    EXPECT_NEAR(grid.range_mm(peakOf(scanline(frame, tip - 1)).index), 22, 0.4) << angle_deg;
  }
}

TEST_P(Needles, RingBetweenTheirWalls) {
  Bench bench;
  bench.settings.effects.reverberation = true;
  const std::vector<double> line = scanline(render(bench.probe, bench.settings, bench.scene, {}, {}, tilted(0)), 128);
  const BeamGrid grid = bench.grid();
  // Lumen of 0.66 diameters, and there and back through walls of 0.17 in steel, at 1.54 mm/us.
  const double spacing_mm = 2 * kRadius_mm * (0.66 + 2 * 0.17 * kSoundSpeed_mmPerUs / 5.79);
  double before = peakOf(line).value;
  for (int ring = 1; ring <= 5; ++ring) {
    const double at_mm = kFocus_mm + ring * spacing_mm;
    const int low = int(grid.sampleAt(at_mm - 0.3)), high = int(grid.sampleAt(at_mm + 0.3));
    const Peak peak = peakOf(std::span(line).subspan(low, high - low));
    EXPECT_NEAR(grid.range_mm(low + peak.index), at_mm, 0.06) << ring;
    EXPECT_NEAR(peak.value / before, ring == 1 ? 0.2 : 0.4, 0.02) << ring;
    before = peak.value;
  }
}

TEST_P(Needles, CastAShadowBehindThemAndLeaveTheRestAsItWas) {
  Bench bench;
  bench.settings = speckleSettings(bench.probe, 256, 1000, 3);
  const BeamGrid grid = bench.grid();
  const EnvelopeFrame without = render(bench.probe, bench.settings, bench.scene);
  bench.settings.effects.transmission = true;
  const EnvelopeFrame frame =
      render(bench.probe, bench.settings, bench.scene, {}, {}, needleAt({0, 30, 15}, {0, 1, 0}));
  const auto part = [&](const EnvelopeFrame& of, double left_mm, double right_mm, double top_mm, double bottom_mm) {
    return valuesIn(of, {int(grid.sampleAt(top_mm)), int(grid.sampleAt(bottom_mm)),
                         int(grid.locate(left_mm, 10).scanline), int(grid.locate(right_mm, 10).scanline)});
  };
  const auto share = [&](auto... window) { return rms(part(frame, window...)) / rms(part(without, window...)); };
  EXPECT_LT(share(-0.2, 0.2, 16.0, 30.0), 0.2);
  EXPECT_EQ(part(frame, -15, 15, 1, 14), part(without, -15, 15, 1, 14)) << "before it";
  EXPECT_EQ(part(frame, 6, 15, 16, 38), part(without, 6, 15, 16, 38)) << "beside it, beyond the beam's skirts";
  EXPECT_EQ(part(frame, -15, -6, 16, 38), part(without, -15, -6, 16, 38)) << "beside it, beyond the beam's skirts";
  // Off the slice it covers less of it.
  double before = 0;
  for (const double off_mm : {0.0, 0.3, 0.6, 0.9, 1.2, 1.8, 3.0}) {
    const EnvelopeFrame beside =
        render(bench.probe, bench.settings, bench.scene, {}, {}, needleAt({30, off_mm, 15}, {1, 0, 0}));
    const double left = rms(part(beside, -10, 10, 17, 19)) / rms(part(without, -10, 10, 17, 19));
    EXPECT_GE(left, before) << off_mm;
    before = left;
    record("left_behind_" + std::to_string(off_mm), left);
  }
  EXPECT_EQ(before, 1);
}

TEST_P(Needles, OutOfReachChangeNothing) {
  const Probe probe = probeNamed("linear");
  ImagingSettings settings = settingsFor(probe);
  settings.scanlines = 64, settings.samples = 256;
  const ScenePtr scene = evenScene(probe, settings);
  const EnvelopeFrame without = render(probe, settings, scene);
  for (const Needle& away : {needleAt({0, 12, 20}, {1, 0, 1}), needleAt({60, 0, 20}, {0, 0, 1}),
                             needleAt({0, 0, 200}, {1, 0, 0}), needleAt({0, 0, -5}, {0, 0, 1})})
    EXPECT_TRUE(identical(render(probe, settings, scene, {}, {}, away), without));
  EXPECT_FALSE(identical(render(probe, settings, scene, {}, {}, tilted(30)), without));
}

TEST_P(Needles, StayWhereTheyAreWhenTissueMoves) {
  const Bench bench;
  const PlaneDisplacement shifted =
      displacementOver(bench.probe, bench.settings, 1, [](double, double) { return shiftBy(2, -3); });
  EXPECT_LT(relativeError(render(bench.probe, bench.settings, bench.scene, {}, shifted, tilted(30)),
                          render(bench.probe, bench.settings, bench.scene, {}, {}, tilted(30))),
            1e-5);
}

/// The skin, 3 mm off and sloping, is drawn to the face, and tissue with it.
TEST_P(Needles, StayStraightAndInTheirTissueWhereSkinIsDrawnToTheFace) {
  Bench bench;
  bench.settings.conformingContact = true;
  AcousticTable table = plainTable();
  table.tissues[kMuscle].impedance_MRayl = 1.7;
  constexpr double kWall_mm = 16;
  const ScenePtr scene = sceneAround(
      bench.probe, bench.settings, 0.7, table,
      [](Vec3 p) { return p.z < 3 + 0.15 * p.x ? kBackground
                          : p.z < kWall_mm     ? kFat
                                               : kMuscle; }, {}, 4);
  const BeamGrid grid = bench.grid();
  const Vec3 tip{0, 0, kWall_mm};
  const EnvelopeFrame tissue = render(bench.probe, bench.settings, scene);
  const int middle = int(std::lround(grid.locate(tip.x, 1).scanline));
  const int below = int(grid.sampleAt(8));
  const auto deeper = [&](const EnvelopeFrame& frame, int line) {
    const std::vector<double> all = scanline(frame, line);
    return grid.range_mm(below + peakOf(std::span(all).subspan(below)).index);
  };
  const double wall_mm = deeper(tissue, middle);
  EXPECT_LT(wall_mm, kWall_mm - 0.8);
  const EnvelopeFrame frame = render(bench.probe, bench.settings, scene, {}, {}, needleAt(tip, {1, 0, 0.25}));
  bench.settings.conformingContact = false;
  const EnvelopeFrame undrawn = render(bench.probe, bench.settings, scene, {}, {}, needleAt(tip, {1, 0, 0.25}));
  EXPECT_NEAR(deeper(undrawn, middle - 60) - deeper(frame, middle - 60), kWall_mm - wall_mm, 0.1);
  const double slope = (deeper(frame, middle - 30) - deeper(frame, middle - 90)) / 60;
  EXPECT_NEAR(slope / grid.scanlineSpacing_mm(0), 0.25, 0.02);
  for (int line = middle - 90; line <= middle - 30; line += 15)
    EXPECT_NEAR(deeper(frame, line), deeper(frame, middle - 90) + slope * (line - middle + 90), 0.05) << line;
}

TEST_P(Needles, LieWhereTheyAreUnderEveryProbe) {
  for (const char* name : {"linear", "curvilinear", "phased"}) {
    const Bench bench(name);
    const Vec3 place{3, 0, 30};
    const EnvelopeFrame frame =
        render(bench.probe, bench.settings, bench.scene, {}, {}, needleAt(place + Vec3{0, 30, kRadius_mm}, {0, 1, 0}));
    const BeamGrid grid = bench.grid();
    const auto at = grid.locate(place.x, place.z);
    const Peak down = peakOf(scanline(frame, int(std::lround(at.scanline))));
    EXPECT_NEAR(grid.range_mm(down.index), grid.range_mm(at.sample), 0.3) << name;
    EXPECT_NEAR(peakOf(acrossLines(frame, int(std::lround(down.index)))).index, at.scanline, 1) << name;
  }
}

TEST_P(Needles, OfAnyKindAndPlaceGiveNumbers) {
  for (const char* name : {"linear", "curvilinear", "phased"}) {
    const Probe probe = probeNamed(name);
    ImagingSettings settings = settingsFor(probe);
    settings.scanlines = 40, settings.samples = 200;
    const ScenePtr scene = evenScene(probe, settings);
    for (const Vec3 direction : {Vec3{0, 0, 1}, Vec3{0, 0, -1}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{1e-7, 0, 1}})
      for (const Vec3 tip_mm : {Vec3{0, 0, 0}, Vec3{0, 0, 15}, Vec3{1000, 0, 1000}, Vec3{0, 0, -60}, Vec3{0, 1, 1e6}})
        for (const double radius_mm : {0.1, 2.0}) {
          Needle needle = needleAt(tip_mm, direction);
          needle.radius_mm = radius_mm, needle.length_mm = 300;
          EXPECT_TRUE(allFinite(render(probe, settings, scene, {}, {}, needle))) << name;
        }
  }
}

}  // namespace
}  // namespace insonate::test
