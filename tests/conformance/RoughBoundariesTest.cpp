#include "conformance/Measure.h"
#include "conformance/Rig.h"

#include <algorithm>
#include <cmath>

namespace insonate::test {
namespace {

class RoughBoundaries : public EngineTest {};
INSONATE_FOR_ALL_ENGINES(RoughBoundaries);

constexpr double kFascia_mm = 21;  // a face of the voxels

/// A flat boundary at the focus between tissues of unlike impedance; the lower one may carry a layer or be rough.
struct Bench {
  Probe probe = probeNamed("linear");
  ImagingSettings settings = silentSettings(probe, 192, 800, 3);
  AcousticTable table = plainTable();
  double spacing_mm = probe.width_mm / 191;

  Bench() {
    settings.effects.reflection = settings.effects.texture = true;
    table.tissues[kMuscle].impedance_MRayl = 1.7;
  }
  /// Depth and height of each scanline's highest echo.
  std::vector<Peak> ridge(const std::string& engine) const {
    const ScenePtr scene =
        sceneAround(probe, settings, 0.7, table, [](Vec3 p) { return p.z < kFascia_mm ? kSoftTissue : kMuscle; });
    const EnvelopeFrame frame = renderWith(engine, probe, settings, *scene);
    std::vector<Peak> peaks;
    for (int line = 8; line < frame.scanlines - 8; ++line) peaks.push_back(peakOf(scanline(frame, line)));
    return peaks;
  }
};

std::vector<double> heights(const std::vector<Peak>& ridge) {
  std::vector<double> values;
  for (const Peak& peak : ridge) values.push_back(peak.value);
  return values;
}

/// Correlation of a ridge's height with itself, so many scanlines aside.
double correlationAside(const std::vector<double>& height, int lines) {
  const std::size_t n = height.size() - std::size_t(lines);
  return correlation(std::span(height).first(n), std::span(height).last(n));
}

TEST_P(RoughBoundaries, ASmoothOneIsAMirror) {
  const std::vector<double> height = heights(Bench().ridge(GetParam()));
  EXPECT_LT(standardDeviation(height) / mean(height), 0.01);
}

/// An outline in an image of a patient is made of grains: 2 mm along it little is left of the correlation.
TEST_P(RoughBoundaries, ARoughOneComesInGrains) {
  Bench bench;
  bench.table.tissues[kMuscle].roughness_dB = 6;
  const std::vector<double> height = heights(bench.ridge(GetParam()));
  EXPECT_GT(standardDeviation(height) / mean(height), 0.4);
  EXPECT_GT(correlationAside(height, 1), 0.9) << "neighbors share the beam";
  EXPECT_LT(correlationAside(height, static_cast<int>(2 / bench.spacing_mm)), 0.6);
}

TEST_P(RoughBoundaries, ARoughOneReturnsLessAndSpreads) {
  const std::vector<Peak> smooth = Bench().ridge(GetParam());
  Bench bench;
  bench.table.tissues[kMuscle].roughness_dB = 6;
  const std::vector<Peak> rough = bench.ridge(GetParam());
  EXPECT_LT(mean(heights(rough)), 0.7 * mean(heights(smooth)));
  double fwhm_mm[2] = {};
  for (const Peak& peak : smooth) fwhm_mm[0] += peak.fwhm / double(smooth.size());
  for (const Peak& peak : rough) fwhm_mm[1] += peak.fwhm / double(rough.size());
  EXPECT_GT(fwhm_mm[1], 1.1 * fwhm_mm[0]);
}

/// A layer's place along a flat boundary has the stated spread, and its echo is mostly speckle.
TEST_P(RoughBoundaries, ALayerWandersAndIsNoRail) {
  Bench bench;
  bench.settings.effects.reflection = false;
  bench.settings.effects.scattering = bench.settings.effects.layers = bench.settings.effects.speckle = true;
  bench.table.tissues[kMuscle].layers = {{-0.5, -0.2, 25, 0.8, 0}};
  const std::vector<Peak> ridge = bench.ridge(GetParam());
  const double sample_mm = bench.settings.depth_mm / bench.settings.samples;
  std::vector<double> depth_mm;
  for (const Peak& peak : ridge) depth_mm.push_back((peak.index + 0.5) * sample_mm);
  EXPECT_NEAR(mean(depth_mm), kFascia_mm + 0.35, 0.15);
  EXPECT_GT(standardDeviation(depth_mm), 0.08);
  EXPECT_LT(standardDeviation(depth_mm), 0.3);
  const std::vector<double> height = heights(ridge);
  EXPECT_GT(standardDeviation(height) / mean(height), 0.25) << "speckle has 0.52, a rail 0";
}

/// The tissue around a vessel has layers of its own, which would fill the dark media of its wall.
TEST_P(RoughBoundaries, AroundAVesselOnlyItsOwnLayersCount) {
  Bench bench;
  bench.settings.effects.reflection = bench.settings.effects.speckle = false;
  bench.settings.effects.scattering = bench.settings.effects.layers = true;
  bench.table.tissues[kArtery].vessel = true;
  bench.table.tissues[kArtery].layers = {{0.8, 1.2, 25, 0, 0}};
  bench.table.tissues[kMuscle].layers = {{-2, 0, 25, 0, 0}};
  const ScenePtr scene = sceneAround(bench.probe, bench.settings, 0.7, bench.table,
                                     [](Vec3 p) { return p.z < kFascia_mm ? kArtery : kMuscle; });
  const EnvelopeFrame frame = renderWith(GetParam(), bench.probe, bench.settings, *scene);
  const std::vector<double> echo = scanline(frame, frame.scanlines / 2);
  const double sample_mm = bench.settings.depth_mm / bench.settings.samples;
  const auto at = [&](double beyond_mm) {
    return echo[static_cast<std::size_t>((kFascia_mm + beyond_mm) / sample_mm)];
  };
  EXPECT_LT(at(0.3), 0.3 * at(1.0));
  EXPECT_LT(at(1.8), 0.3 * at(1.0));
}

/// The far wall of a vessel is as smooth as its near wall.
TEST_P(RoughBoundaries, TheFarWallOfAVesselHasItsSmoothness) {
  Bench bench;
  bench.table.tissues[kArtery].vessel = true;
  bench.table.tissues[kMuscle].roughness_dB = 6;
  const ScenePtr scene = sceneAround(bench.probe, bench.settings, 0.7, bench.table,
                                     [](Vec3 p) { return p.z < kFascia_mm ? kArtery : kMuscle; });
  const EnvelopeFrame frame = renderWith(GetParam(), bench.probe, bench.settings, *scene);
  std::vector<double> height;
  for (int line = 8; line < frame.scanlines - 8; ++line) height.push_back(peakOf(scanline(frame, line)).value);
  EXPECT_LT(standardDeviation(height) / mean(height), 0.01);
}

}  // namespace
}  // namespace insonate::test
