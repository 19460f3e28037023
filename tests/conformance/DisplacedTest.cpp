#include "conformance/Measure.h"
#include "conformance/Rig.h"

#include <algorithm>
#include <cmath>

namespace insonate::test {
namespace {

/// Frames of tissue that has moved; the truth is known for each displacement.
class Displaced : public EngineTest {
 protected:
  Probe probe_ = probeNamed("linear");
};
INSONATE_FOR_ALL_ENGINES(Displaced);

constexpr int kLines = 128, kSamples = 500;

/// Layers, a vessel, bone and gas under a level skin at z = 0.
LabelPhantom layers() {
  return paint(
      gridOver({-63, -14, -35}, {63, 14, 70}, {0.9, 0.9, 0.7}),
      [](Vec3 p) {
        if (p.z < 0) return kBackground;
        if (p.z < 2.1) return kSkin;
        if (p.z < 7) return kFat;
        if (p.x > 12 && p.z > 11.2) return kAirway;
        if (std::hypot(p.x + 6, p.z - 16 + 0.1 * p.y) < 5) return kVein;
        return std::hypot(p.x - 9, p.z - 22) < 4 ? kBone : kMuscle;
      },
      [](Vec3 p) { return std::lround(30 * std::sin(0.8 * p.x) * std::cos(0.9 * p.z) + 20 * std::sin(0.7 * p.y)); });
}
const Region kAll{{-63, -14, -35}, {63, 14, 70}};

ImagingSettings fullSettings(const Probe& probe, Look look) {
  ImagingSettings settings = settingsFor(probe);
  settings.look = look;
  settings.scanlines = kLines, settings.samples = kSamples;
  settings.depth_mm = std::clamp(40.0, probe.minDepth_mm, probe.maxDepth_mm);
  return settings;
}

TEST_P(Displaced, NoShiftIsNoDisplacement) {
  const ScenePtr scene = sceneOf(layers(), *loadAcousticTable("neck"), kAll);
  for (const Look look : {Look::Coherent, Look::Thesis}) {
    const ImagingSettings settings = fullSettings(probe_, look);
    const PlaneDisplacement none = displacementOver(probe_, settings, 1, [](double, double) { return shiftBy(0, 0); });
    EXPECT_LT(relativeError(render(probe_, settings, scene, {}, none), render(probe_, settings, scene)), 1e-6);
  }
}

TEST_P(Displaced, TheSameShiftEverywhereIsAMovedProbe) {
  const ScenePtr scene =
      sceneOf(layers(), *loadAcousticTable("neck"), kAll, {{{3, 0.2, 12}, 40}, {{-4, -0.3, 25}, 40}});
  for (const char* name : {"linear", "curvilinear", "phased"})
    for (const Look look : {Look::Coherent, Look::Thesis}) {
      const Probe probe = probeNamed(name);
      ImagingSettings settings = fullSettings(probe, look);
      if (look == Look::Thesis) settings.effects.speckle = false;  // it stays with the probe
      const PlaneDisplacement shift =
          displacementOver(probe, settings, 1.3, [](double, double) { return shiftBy(0.73, -1.31); });
      const Transform pose = turned({0, 1, 0}, 5), there = pose * moved({0.73, 0, -1.31});
      const EnvelopeFrame seen = render(probe, settings, scene, pose, shift);
      const double error = relativeError(seen, render(probe, settings, scene, there));
      EXPECT_LT(error, 2e-4) << name;
      EXPECT_GT(relativeError(seen, render(probe, settings, scene, pose)), 0.1) << name;
      record(std::string(name) + (look == Look::Thesis ? "_thesis" : "") + "_relative_error", error);
    }
}

/// Depth of the brightest echo on a scanline near an expected depth.
double echoDepth_mm(const EnvelopeFrame& frame, const ImagingSettings& settings, int line, double near_mm) {
  const double step_mm = settings.depth_mm / settings.samples;
  const int first = static_cast<int>((near_mm - 1.5) / step_mm), end = static_cast<int>((near_mm + 1.5) / step_mm);
  return (first + peakOf(valuesIn(frame, {first, end, line, line + 1})).index + 0.5) * step_mm;
}

/// Tissue that lay at z (1 + strain) is seen at z.
PlaneDisplacement compressed(const Probe& probe, const ImagingSettings& settings, double strain) {
  return displacementOver(probe, settings, 0.7, [=](double, double z) { return shiftBy(0, strain * z); });
}

TEST_P(Displaced, CompressionBringsBoundariesWhereTheyBelong) {
  AcousticTable table = plainTable();
  table.tissues[kFat].impedance_MRayl = 1.4;
  for (const Look look : {Look::Coherent, Look::Thesis})
    for (const int planes : {1, 3}) {
      ImagingSettings settings = silentSettings(probe_, 64, 1600, planes);  // a sample falls on each peak
      settings.look = look;
      settings.effects.reflection = true;
      settings.effects.beam = look == Look::Coherent;  // the other's blur trails behind
      const ScenePtr scene = sceneAround(
          probe_, settings, 0.7, table, [](Vec3 p) { return p.z > 10.5 && p.z < 28 ? kFat : kMuscle; }, {}, 15);
      const EnvelopeFrame rest = render(probe_, settings, scene);
      for (const double strain : {-0.2, 0.1, 0.33}) {
        const EnvelopeFrame frame = render(probe_, settings, scene, {}, compressed(probe_, settings, strain));
        for (const double rest_mm : {10.5, 28.0}) {
          const double depth_mm = echoDepth_mm(frame, settings, 32, rest_mm / (1 + strain));
          EXPECT_NEAR(depth_mm, rest_mm / (1 + strain), 0.1) << planes << " planes, strain " << strain;
          if (look == Look::Thesis) continue;  // there a compressed interface is a sharper one
          const double asAtRest = largest(frame) / largest(rest);
          EXPECT_NEAR(asAtRest, 1, 0.04) << "level boundaries stay square to the beam: " << strain;
        }
      }
    }
}

/// An undisturbed frame sampled at the rest point of each sample of a linear probe's frame, bilinear.
std::vector<double> warped(const EnvelopeFrame& frame, const BeamGrid& grid, const Window& w, const auto& shiftAt) {
  std::vector<double> values;
  for (int m = w.firstSample; m < w.endSample; ++m)
    for (int l = w.firstLine; l < w.endLine; ++l) {
      const double x = grid.origin(l).x, z = grid.range_mm(m);
      const PlaneDisplacement::Shift by = shiftAt(x, z);
      const auto at = grid.locate(x + by.x_mm, z + by.z_mm);
      const int m0 = static_cast<int>(std::floor(at.sample)), l0 = static_cast<int>(std::floor(at.scanline));
      const double down = at.sample - m0, right = at.scanline - l0;
      const auto value = [&](int dm, int dl) {
        return double(frame.amplitude[std::size_t(m0 + dm) * frame.scanlines + l0 + dl]);
      };
      values.push_back((1 - down) * ((1 - right) * value(0, 0) + right * value(0, 1)) +
                       down * ((1 - right) * value(1, 0) + right * value(1, 1)));
    }
  return values;
}

struct SpeckleBench {
  Probe probe = probeNamed("linear");
  ImagingSettings settings = speckleSettings(probe, 256, 800, 3);
  ScenePtr scene = evenScene(probe, settings, plainTable(), {}, 15);
  BeamGrid grid{probe, settings};
};

TEST_P(Displaced, SpeckleMovesWithCompressedTissue) {
  const SpeckleBench bench;
  const EnvelopeFrame rest = render(bench.probe, bench.settings, bench.scene);
  for (const double strain : {-0.05, 0.03, 0.1}) {
    const EnvelopeFrame frame =
        render(bench.probe, bench.settings, bench.scene, {}, compressed(bench.probe, bench.settings, strain));
    const Window w{20, static_cast<int>(780 / std::max(1.0, 1 + strain)), 10, 246};
    const double same = correlation(
        valuesIn(frame, w), warped(rest, bench.grid, w, [=](double, double z) { return shiftBy(0, strain * z); }));
    EXPECT_GT(same, 0.9) << "strain " << strain;
    EXPECT_LT(correlation(valuesIn(frame, w), valuesIn(rest, w)), 0.3) << "strain " << strain;
    record("strain_" + std::to_string(std::lround(100 * strain)) + "_percent", same);
  }
}

TEST_P(Displaced, ShearMovesSpeckleAndPointsAlongTheScanlines) {
  const SpeckleBench bench;
  const auto shear = [](double, double z) { return shiftBy(0.2 * (z - 20), 0); };
  const PlaneDisplacement sheared = displacementOver(bench.probe, bench.settings, 2, shear);
  const EnvelopeFrame rest = render(bench.probe, bench.settings, bench.scene);
  const Window w{20, 780, 40, 216};
  const double same = correlation(valuesIn(render(bench.probe, bench.settings, bench.scene, {}, sheared), w),
                                  warped(rest, bench.grid, w, shear));
  EXPECT_GT(same, 0.9);
  record("correlation", same);
}

/// The brightest place of a frame with one point, in the probe's plane.
Vec3 brightestAt(const EnvelopeFrame& frame, const BeamGrid& grid) {
  const auto top = std::max_element(frame.amplitude.begin(), frame.amplitude.end()) - frame.amplitude.begin();
  const int sample = static_cast<int>(top / frame.scanlines), line = static_cast<int>(top % frame.scanlines);
  const double line0 = std::max(0, line - 4), sample0 = std::max(0, sample - 10);
  const Peak across =
      peakOf(valuesIn(frame, {sample, sample + 1, std::max(0, line - 4), std::min(frame.scanlines, line + 5)}));
  const Peak down =
      peakOf(valuesIn(frame, {std::max(0, sample - 10), std::min(frame.samples, sample + 11), line, line + 1}));
  return grid.origin(line0 + across.index) + grid.direction(line0 + across.index) * grid.range_mm(sample0 + down.index);
}

TEST_P(Displaced, PointsAreSeenWhereTheirTissueIs) {
  for (const char* name : {"linear", "curvilinear", "phased"}) {
    const Probe probe = probeNamed(name);
    ImagingSettings settings = silentSettings(probe, 256, 1000, 1);
    const double depth_mm = settings.depth_mm;
    const auto swirl = [=](double x, double z) {
      const auto turn = swirlAt(x, z, 0, 0.5 * depth_mm, 40, 0.25 * depth_mm);
      return shiftBy(turn.x_mm + 0.1 * z, turn.z_mm + 0.3 * z);
    };
    const PlaneDisplacement displacement = displacementOver(probe, settings, 0.5, swirl);
    const BeamGrid grid(probe, settings);
    for (const auto& [side, share] : {std::pair{0.013, 0.45}, {-0.3, 0.6}, {0.4, 0.3}}) {
      const double line = 127.5 + 127.5 * side;
      const Vec3 seen = grid.origin(line) + grid.direction(line) * (share * depth_mm);
      const auto by = swirl(seen.x, seen.z);
      const Region region = regionOf(probe, settings, {}, 0.6 * depth_mm);
      const ScenePtr scene =
          sceneOf(paint(gridOver(region.low_mm, region.high_mm, 30), [](Vec3) { return kSoftTissue; }), plainTable(),
                  region, {{{seen.x + by.x_mm, 0, seen.z + by.z_mm}, 100}});
      const Vec3 found = brightestAt(render(probe, settings, scene, {}, displacement), grid);
      EXPECT_LT(std::hypot(found.x - seen.x, found.z - seen.z), 0.1) << name << " at " << seen.x << ", " << seen.z;
    }
  }
}

/// Every part of a turning image is the undisturbed one's, so that there are no seams, whatever the lattice's step.
TEST_P(Displaced, ASwirlTearsNothing) {
  const SpeckleBench bench;
  const EnvelopeFrame rest = render(bench.probe, bench.settings, bench.scene);
  const auto swirl = [](double x, double z) { return swirlAt(x, z, 1, 20, 12, 9); };
  double least = 1;
  for (const double step_mm : {0.5, 1.0}) {
    const EnvelopeFrame frame = render(bench.probe, bench.settings, bench.scene, {},
                                       displacementOver(bench.probe, bench.settings, step_mm, swirl));
    for (int m = 40; m + 80 <= 760; m += 80)
      for (int l = 24; l + 26 <= 232; l += 26) {
        const Window w{m, m + 80, l, l + 26};
        least = std::min(least, correlation(valuesIn(frame, w), warped(rest, bench.grid, w, swirl)));
      }
  }
  EXPECT_GT(least, 0.85);
  record("least_correlation", least);
}

/// The displacement has brought the skin to the face: nothing is left to draw to it.
TEST_P(Displaced, SkinThatMetTheFaceIsNotDrawnToItAgain) {
  const ScenePtr scene = sceneOf(layers(), *loadAcousticTable("neck"), kAll);
  for (const Look look : {Look::Coherent, Look::Thesis}) {
    ImagingSettings settings = fullSettings(probe_, look);
    const Transform pressed = moved({0, 0, 5});
    const auto into = [](double, double z) { return shiftBy(0, -5 * std::exp(-std::max(z, 0.0) / 20)); };
    const PlaneDisplacement solved = displacementOver(probe_, settings, 0.5, into);
    const EnvelopeFrame drawn = render(probe_, settings, scene, pressed, solved);
    settings.conformingContact = false;
    const double error = relativeError(drawn, render(probe_, settings, scene, pressed, solved));
    EXPECT_LT(error, 0.1);
    EXPECT_GT(relativeError(drawn, render(probe_, settings, scene, pressed)), 0.5);
    record(look == Look::Thesis ? "thesis_relative_error" : "relative_error", error);
  }
}

TEST_P(Displaced, SkinThatHasGoneLosesContact) {
  const ScenePtr scene = sceneOf(layers(), *loadAcousticTable("neck"), kAll);
  for (const Look look : {Look::Coherent, Look::Thesis}) {
    const ImagingSettings settings = fullSettings(probe_, look);
    const PlaneDisplacement gone =
        displacementOver(probe_, settings, 1, [](double x, double) { return shiftBy(0, x < 0 ? 0 : -13); });
    const EnvelopeFrame frame = render(probe_, settings, scene, {}, gone);
    // The rays of the aperture come from where there is skin; their sweep blurs them a little beyond their cone.
    EXPECT_LT(rms(valuesIn(frame, {0, kSamples, 80, kLines})), look == Look::Coherent ? 1e-4 : 1e-6);
    EXPECT_GT(rms(valuesIn(frame, {20, kSamples / 2, 4, 48})), 0.05);
  }
}

TEST_P(Displaced, TissueFromBeyondTheSceneReadsAsItsOutermost) {
  AcousticTable table = plainTable();
  table.tissues[kFat].echogenicity_dB = 10;
  for (const Look look : {Look::Coherent, Look::Thesis}) {
    ImagingSettings settings = uniformSettings(probe_, 64, 400);
    settings.look = look;
    const Region frame = regionAround(probe_, settings);
    const LabelPhantom phantom = paint(alignedGridOver(frame, 1.4), [](Vec3 p) { return p.z < 30 ? kMuscle : kFat; });
    const ScenePtr scene = sceneOf(phantom, table, frame);
    const PlaneDisplacement fromBelow =
        displacementOver(probe_, settings, 1, [](double, double) { return shiftBy(0, 20); });
    const EnvelopeFrame seen = render(probe_, settings, scene, {}, fromBelow);
    EXPECT_NEAR(mean(valuesIn(seen, {360, 390, 10, 54})), std::pow(10, 0.5), 0.05);
    EXPECT_NEAR(mean(valuesIn(seen, {20, 60, 10, 54})), 1, 0.02);
  }
}

TEST_P(Displaced, LargeAndWildDisplacementsAreSurvived) {
  const ScenePtr scene = sceneOf(layers(), *loadAcousticTable("neck"), kAll, {{{3, 0.2, 12}, 40}});
  for (const char* name : {"linear", "curvilinear", "phased"})
    for (const Look look : {Look::Coherent, Look::Thesis}) {
      const Probe probe = probeNamed(name);
      ImagingSettings settings = fullSettings(probe, look);
      settings.samples = 200;
      unsigned state = 1;
      const auto random = [&] { return 40.0 * ((state = state * 1664525U + 1013904223U) >> 8) / 16777216.0 - 20; };
      const auto wild =
          displacementOver(probe, settings, 2, [&](double, double) { return shiftBy(random(), random()); });
      EXPECT_TRUE(allFinite(render(probe, settings, scene, {}, wild))) << name;
      for (const double by_mm : {-20.0, 20.0}) {
        PlaneDisplacement even{
            .left_mm = 5, .top_mm = 5, .step_mm = 1, .columns = 1, .rows = 1, .restFromDisplayed = {}};
        even.restFromDisplayed = {shiftBy(-by_mm, by_mm)};
        EXPECT_TRUE(allFinite(render(probe, settings, scene, {}, even))) << name;
      }
    }
}

TEST_P(Displaced, RegionsGrowByTheLargestShift) {
  const ImagingSettings settings = settingsFor(probe_);
  const Region still = regionOf(probe_, settings, {}), shifted = regionOf(probe_, settings, {}, 20);
  EXPECT_EQ(shifted.low_mm, still.low_mm - (Vec3{20, 0, 20}));
  EXPECT_EQ(shifted.high_mm, still.high_mm + (Vec3{20, 0, 20}));
}

}  // namespace
}  // namespace insonate::test
