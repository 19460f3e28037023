#include "conformance/Measure.h"
#include "conformance/Rig.h"

#include <insonate/ultrasound/PointSpread.h>

#include <cmath>

namespace insonate::test {
namespace {

class PointTargets : public EngineTest {};
INSONATE_FOR_ALL_ENGINES(PointTargets);

struct Bench {
  Probe probe;
  ImagingSettings settings;

  explicit Bench(const std::string& name) : probe(probeNamed(name)), settings(silentSettings(probe, 256, 1000, 1)) {}

  ScenePtr sceneWith(std::vector<PointTarget> points) const {
    const Region region = regionAround(probe, settings);
    return sceneOf(paint(gridOver(region.low_mm, region.high_mm, 30), [](Vec3) { return kSoftTissue; }), plainTable(),
                   region, std::move(points));
  }
};

struct Spot {
  double lateral_mm, axial_mm;  ///< probe frame
  double amplitude, axialFwhm_mm, lateralFwhm_mm;
};

/// The point nearest to a place of the imaging plane; others must be 6 mm away.
Spot spotNear(const EnvelopeFrame& frame, const Bench& bench, double lateral_mm, double axial_mm) {
  const BeamGrid grid(bench.probe, bench.settings);
  const auto at = grid.locate(lateral_mm, axial_mm);
  const int line = int(std::lround(at.scanline)), sample = int(std::lround(at.sample));
  const int lines = int(3 / grid.scanlineSpacing_mm(axial_mm)) + 4, samples = int(3 / grid.step_mm());
  const Window near{std::max(0, sample - samples), std::min(frame.samples, sample + samples + 1),
                    std::max(0, line - lines), std::min(frame.scanlines, line + lines + 1)};
  int topSample = 0, topLine = 0;
  float top = 0;
  for (int m = near.firstSample; m < near.endSample; ++m)
    for (int l = near.firstLine; l < near.endLine; ++l)
      if (const float a = frame.amplitude[std::size_t(m) * frame.scanlines + l]; a > top)
        top = a, topSample = m, topLine = l;
  Peak along = peakOf(valuesIn(frame, {near.firstSample, near.endSample, topLine, topLine + 1}));
  Peak across = peakOf(valuesIn(frame, {topSample, topSample + 1, near.firstLine, near.endLine}));
  along.index += near.firstSample, across.index += near.firstLine;
  const double range_mm = grid.range_mm(along.index);
  const Vec3 found = grid.origin(across.index) + grid.direction(across.index) * range_mm;
  return {found.x, found.z, along.value, along.fwhm * grid.step_mm(), across.fwhm * grid.scanlineSpacing_mm(range_mm)};
}

const char* const kProbes[] = {"linear", "curvilinear", "phased"};

TEST_P(PointTargets, LieWhereTheyAreForEveryProbe) {
  double worst_mm = 0;
  for (const char* name : kProbes) {
    const Bench bench(name);
    const BeamGrid grid(bench.probe, bench.settings);
    std::vector<PointTarget> points;
    for (const double share : {0.27, 0.5, 0.713, 0.9})
      for (const double side : {-0.7, 0.013, 0.61}) {
        const double line = 127.5 + 127.5 * side;
        points.push_back({grid.origin(line) + grid.direction(line) * (share * bench.settings.depth_mm), 100});
      }
    const EnvelopeFrame frame = render(bench.probe, bench.settings, bench.sceneWith(points));
    for (const auto& [p, amplitude] : points) {
      const Spot spot = spotNear(frame, bench, p.x, p.z);
      const double off_mm = std::hypot(spot.lateral_mm - p.x, spot.axial_mm - p.z);
      EXPECT_LT(off_mm, 0.1) << name << " at " << p.x << ", " << p.z << " mm";
      worst_mm = std::max(worst_mm, off_mm);
    }
  }
  record("worst_off_mm", worst_mm);
}

TEST_P(PointTargets, AreAsWideAsTheProbeSaysAndNarrowestAtTheFocus) {
  for (const char* name : kProbes) {
    const Bench bench(name);
    const double focus_mm = bench.settings.focus_mm;
    const std::vector<double> ranges_mm{0.3 * focus_mm, 0.65 * focus_mm, focus_mm, 1.35 * focus_mm, 1.8 * focus_mm};
    std::vector<PointTarget> points;
    // On a scanline, so that the frame holds the peak itself.
    const BeamGrid grid(bench.probe, bench.settings);
    const auto place = [&](double range_mm) { return grid.origin(128) + grid.direction(128) * range_mm; };
    for (const double range_mm : ranges_mm) points.push_back({place(range_mm), 100});
    const EnvelopeFrame frame = render(bench.probe, bench.settings, bench.sceneWith(points));
    double narrowest_mm = 1e9, narrowestAt_mm = 0;
    for (const double range_mm : ranges_mm) {
      const Spot spot = spotNear(frame, bench, place(range_mm).x, place(range_mm).z);
      const double axial = spot.axialFwhm_mm / axialFwhm_mm(bench.probe, bench.settings);
      const double lateral = spot.lateralFwhm_mm / lateralFwhm_mm(bench.probe, bench.settings, range_mm);
      EXPECT_NEAR(axial, 1, 0.1) << name << " at " << range_mm << " mm";
      EXPECT_NEAR(lateral, 1, 0.1) << name << " at " << range_mm << " mm";
      EXPECT_NEAR(spot.amplitude, 100, 5) << name << " at " << range_mm << " mm";
      if (spot.lateralFwhm_mm < narrowest_mm) narrowest_mm = spot.lateralFwhm_mm, narrowestAt_mm = range_mm;
      const std::string which = std::string(name) + "_" + std::to_string(int(std::lround(range_mm))) + "_mm";
      record("axial_over_theory_" + which, axial);
      record("lateral_over_theory_" + which, lateral);
      record("amplitude_of_100_" + which, spot.amplitude);
    }
    // If receive has its whole aperture before the focus, the beam widens with depth from there on.
    if (receiveAperture_mm(bench.probe, focus_mm) < bench.probe.maxAperture_mm) {
      EXPECT_EQ(narrowestAt_mm, focus_mm) << name;
    }
  }
}

TEST_P(PointTargets, FollowTheFocusThatIsSet) {
  Bench bench("linear");
  const std::vector<double> ranges_mm{4, 10, 20, 29, 36};
  std::vector<PointTarget> points;
  for (const double range_mm : ranges_mm) points.push_back({{0, 0, range_mm}, 1});
  for (const double focus_mm : {10.0, 29.0}) {
    bench.settings.focus_mm = focus_mm;
    const EnvelopeFrame frame = render(bench.probe, bench.settings, bench.sceneWith(points));
    double narrowest_mm = 1e9, narrowestAt_mm = 0;
    for (const double range_mm : ranges_mm) {
      const Spot spot = spotNear(frame, bench, 0, range_mm);
      if (spot.lateralFwhm_mm < narrowest_mm) narrowest_mm = spot.lateralFwhm_mm, narrowestAt_mm = range_mm;
    }
    EXPECT_EQ(narrowestAt_mm, focus_mm);
  }
}

TEST_P(PointTargets, DoNotShowOutsideTheFieldOfView) {
  const Bench bench("linear");
  const auto scene = bench.sceneWith({{{25, 0, 20}, 100}, {{0, 0, 45}, 100}, {{0, 0, -3}, 100}, {{0, 40, 20}, 100}});
  EXPECT_LT(largest(render(bench.probe, bench.settings, scene)), 1e-6);
}

}  // namespace
}  // namespace insonate::test
