#include "conformance/Measure.h"
#include "conformance/Rig.h"

#include <cmath>
#include <numbers>
#include <tuple>

namespace insonate::test {
namespace {

class Reflection : public EngineTest {};
INSONATE_FOR_ALL_ENGINES(Reflection);

constexpr int kLines = 96, kSamples = 500;
/// Envelope of R = 1 square to the beam over unit speckle, as the model states it.
const double kGain = std::pow(10, 58.0 / 20);

AcousticTable twoTissues(double z1_MRayl, double z2_MRayl) {
  AcousticTable table = plainTable();
  table.tissues[kSoftTissue].impedance_MRayl = z1_MRayl;
  table.tissues[kMuscle].impedance_MRayl = z2_MRayl;
  return table;
}

double reflectionOf(double z1, double z2) {
  return (z2 - z1) / (z2 + z1);
}

TEST_P(Reflection, AmplitudeIsTheDifferenceOverTheSumOfImpedances) {
  const Probe probe = probeNamed("linear");
  ImagingSettings settings = silentSettings(probe, 16, kSamples, 3);
  settings.effects.reflection = true;
  double worst = 0;
  for (const auto& [z1, z2] :
       {std::pair{1.36, 1.65}, {1.65, 1.36}, {1.60, 1.63}, {1.65, 5.95}, {5.95, 1.65}, {1.65, 0.0004}})
    for (const double depth_mm : {9.0, 20.2, 33.15}) {
      const auto scene = sceneAround(probe, settings, 0.5, twoTissues(z1, z2),
                                     [&](Vec3 p) { return p.z < depth_mm ? kSoftTissue : kMuscle; });
      const Peak peak = peakOf(scanline(render(probe, settings, scene), 8));
      const double ratio = peak.value / (std::abs(reflectionOf(z1, z2)) * kGain);
      EXPECT_NEAR(ratio, 1, 0.1) << z1 << " to " << z2 << " MRayl at " << depth_mm << " mm";
      const double place_mm = (peak.index + 0.5) * settings.depth_mm / settings.samples;
      EXPECT_NEAR(place_mm, depth_mm, 0.3) << "half a voxel";
      worst = std::max(worst, std::abs(ratio - 1));
    }
  record("worst_relative_error", worst);
}

/// The echo of a boundary is the area of its pulse: tilted, the beam's width spreads it along the scanline, which
/// lowers its peak but not what comes back.
double echoArea(const EnvelopeFrame& frame) {
  const auto sums = lineSums(frame);
  return mean(std::span(sums).subspan(sums.size() / 3, sums.size() / 3));
}

double lobeAt(double tilt_deg, double exponent, double diffuse) {
  const double cosine = std::cos(tilt_deg * std::numbers::pi / 180);
  return (1 - diffuse) * std::pow(cosine, exponent) + diffuse * cosine;
}

struct Tilt {
  const char* name;
  Vec3 axis;  ///< of the probe frame
};
const std::vector<Tilt> kTilts{{"in_plane", {0, 1, 0}}, {"out_of_plane", {1, 0, 0}}, {"both", {1, 1, 0}}};

TEST_P(Reflection, FallsWithTheProbesTiltAsTheLobe) {
  const Probe probe = probeNamed("linear");
  for (const auto& [exponent, diffuse] : {std::pair{12.0, 0.15}, {4.0, 0.0}})
    for (const int planes : {1, 3, 5}) {
      ImagingSettings settings = silentSettings(probe, kLines, kSamples, planes);
      settings.effects.reflection = true;
      AcousticTable table = twoTissues(1.6, 1.7);
      for (AcousticTissue& t : table.tissues) t.specularExponent = exponent, t.specularDiffuse = diffuse;
      Region region = regionAround(probe, settings);
      const Vec3 room{12, 12, 12};
      // A single plane takes distances at their word, which coarse voxels do not keep.
      const double voxel_mm = planes == 1 ? 0.7 : 1.4;
      const auto scene = sceneOf(paint(gridOver({-35, -21, -31.8}, {35, 21, 67.6}, voxel_mm),
                                       [](Vec3 p) { return p.z < 20 ? kSoftTissue : kMuscle; }),
                                 table, {region.low_mm - room, region.high_mm + room});
      const double square = echoArea(render(probe, settings, scene));
      for (const auto& [name, axis] : kTilts)
        for (const double tilt_deg : {10.0, 20.0, 30.0, 45.0}) {
          const EnvelopeFrame frame = render(probe, settings, scene, turned(axis, tilt_deg, {0, 0, 20}));
          const double lobe = lobeAt(tilt_deg, exponent, diffuse);
          const double area = echoArea(frame) / square / lobe;
          EXPECT_NEAR(area, 1, 0.1) << name << " tilt " << tilt_deg << " planes " << planes << " n " << exponent;
          const std::string which = std::string(name) + "_" + std::to_string(int(tilt_deg)) + "_planes_" +
                                    std::to_string(planes) + "_n_" + std::to_string(int(exponent));
          record("area_over_theory_" + which, area);
        }
    }
}

/// Amplitudes of a point at 20 mm, by its distance from the beam along a direction across it, 0.1 mm apart.
constexpr double kProfileStep_mm = 0.1;
std::vector<double> profileByPoint(const std::string& engine, const Probe& probe, Vec3 along) {
  const ImagingSettings settings = silentSettings(probe, 256, 1000, 1);
  const Region region = regionAround(probe, settings);
  const BeamGrid grid(probe, settings);
  const ScenePtr scene = sceneOf(paint(gridOver(region.low_mm, region.high_mm, 30), [](Vec3) { return kSoftTissue; }),
                                 plainTable(), region, {{grid.origin(128) + Vec3{0, 0, 20}, 100}});
  const auto at = std::size_t(std::lround(grid.sampleAt(20))) * 256 + 128;
  std::vector<double> profile;
  for (int n = -30; n <= 30; ++n)
    profile.push_back(renderWith(engine, probe, settings, *scene, moved((n * kProfileStep_mm) * along)).amplitude[at]);
  return profile;
}

/// Share of a plane's echo that is left at the peak where the plane lies so steep, of a Gaussian pulse.
double leftOnSlope(const std::vector<double>& profile, double slope, double pulse_mm) {
  double left = 0, all = 0;
  for (int n = -30; n <= 30; ++n) {
    const double late = n * kProfileStep_mm * slope / pulse_mm;
    left += profile[30 + n] * std::exp(-4 * std::numbers::ln2 * late * late), all += profile[30 + n];
  }
  return left / all;
}

/// A beam meets a slope over a range of depths. Its echo, as wide as the pulse where the boundary lies square, spreads
/// and its peak falls, as with a real array: within the plane by the beam's profile, across by the slice's, however few
/// scanlines and planes stand for them.
TEST_P(Reflection, SpreadsOverASlopeByTheWidthOfTheBeam) {
  const Probe probe = probeNamed("linear");
  AcousticTable table = twoTissues(1.6, 1.7);
  for (AcousticTissue& t : table.tissues) t.specularExponent = 4, t.specularDiffuse = 0;
  const std::vector<double> inPlane = profileByPoint(GetParam(), probe, {1, 0, 0});
  std::vector<double> outOfPlane = profileByPoint(GetParam(), probe, {0, 1, 0});
  // Side lobes alternate in phase and cancel over a plane; elevation planes stand for the main lobe alone.
  for (double& value : outOfPlane)
    if (value < 0.05 * outOfPlane[30]) value = 0;
  double worst = 0;
  for (const int lines : {192, 256}) {
    ImagingSettings settings = silentSettings(probe, lines, 1000, 3);
    settings.effects.reflection = true;
    const Region region = regionAround(probe, settings);
    const Vec3 room{12, 12, 12};
    const auto scene = sceneOf(paint(gridOver({-35, -21, -31.8}, {35, 21, 67.6}, 1.4),
                                     [](Vec3 p) { return p.z < 20 ? kSoftTissue : kMuscle; }),
                               table, {region.low_mm - room, region.high_mm + room});
    const double step_mm = settings.depth_mm / settings.samples;
    const auto peakAt = [&](Vec3 axis, double tilt_deg) {
      return peakOf(scanline(render(probe, settings, scene, turned(axis, tilt_deg, {0, 0, 20})), lines / 2));
    };
    const Peak square = peakAt({0, 1, 0}, 0);
    for (const auto& [name, axis, profile] :
         {std::tuple{"in_plane", Vec3{0, 1, 0}, &inPlane}, {"out_of_plane", Vec3{1, 0, 0}, &outOfPlane}})
      for (const double tilt_deg : {10.0, 20.0, 30.0, 45.0}) {
        const double left = leftOnSlope(*profile, std::tan(tilt_deg * std::numbers::pi / 180), square.fwhm * step_mm);
        const double overTheory = peakAt(axis, tilt_deg).value / square.value / left / lobeAt(tilt_deg, 4, 0);
        EXPECT_NEAR(overTheory, 1, 0.1) << name << " tilt " << tilt_deg << ", " << lines << " scanlines";
        record(std::string(name) + "_" + std::to_string(int(tilt_deg)) + "_lines_" + std::to_string(lines), overTheory);
        worst = std::max(worst, std::abs(overTheory - 1));
      }
  }
  record("worst_peak_error", worst);
}

TEST_P(Reflection, FallsWithTheBoundarysTiltAsTheLobe) {
  const Probe probe = probeNamed("linear");
  ImagingSettings settings = silentSettings(probe, kLines, kSamples, 3);
  settings.effects.reflection = true;
  AcousticTable table = twoTissues(1.6, 1.7);
  for (AcousticTissue& t : table.tissues) t.specularExponent = 12, t.specularDiffuse = 0.15;
  const auto areaAt = [&](Vec3 axis, double tilt_deg, double depth_mm) {
    const Vec3 normal = turned(axis, tilt_deg).linear * Vec3{0, 0, 1};
    return echoArea(render(probe, settings, sceneAround(probe, settings, 0.5, table, [&](Vec3 p) {
                             return dot(normal, p - Vec3{0, 0, depth_mm}) < 0 ? kSoftTissue : kMuscle;
                           })));
  };
  const double square = areaAt({1, 0, 0}, 0, 20);
  for (const auto& [name, axis] : kTilts)
    for (const double tilt_deg : {20.0, 40.0}) {
      // Voxel steps meet the scanlines in other phases at other depths.
      double area = 0;
      for (const double depth_mm : {19.9, 20.05, 20.2}) area += areaAt(axis, tilt_deg, depth_mm) / square / 3;
      EXPECT_NEAR(area / lobeAt(tilt_deg, 12, 0.15), 1, 0.1) << name << " tilt " << tilt_deg;
      record("area_over_theory_" + std::string(name) + "_" + std::to_string(int(tilt_deg)),
             area / lobeAt(tilt_deg, 12, 0.15));
    }
}

TEST_P(Reflection, TakesItsShareFromWhatPasses) {
  const Probe probe = probeNamed("linear");
  ImagingSettings settings = uniformSettings(probe, 16, kSamples, 3);
  settings.effects.transmission = true;
  for (const auto& [z1, z2] : {std::pair{1.36, 1.65}, {1.65, 5.95}, {5.95, 1.65}, {1.0, 20.0}}) {
    const auto scene = sceneAround(probe, settings, 0.5, twoTissues(z1, z2),
                                   [&](Vec3 p) { return p.z < 14 || p.z > 26 ? kSoftTissue : kMuscle; });
    const EnvelopeFrame frame = render(probe, settings, scene);
    const auto level = [&](double mm) { return frame.amplitude[std::size_t(mm / 40 * kSamples) * 16 + 8]; };
    const double passes = 1 - std::pow(reflectionOf(z1, z2), 2);
    EXPECT_NEAR(level(8), 1, 0.01);
    EXPECT_NEAR(level(20) / passes, 1, 0.02) << z1 << " to " << z2;
    EXPECT_NEAR(level(32) / (passes * passes), 1, 0.02) << z1 << " to " << z2;
  }
}

TEST_P(Reflection, MatchedBoundaryIsSilentWhateverTheLabels) {
  const Probe probe = probeNamed("linear");
  ImagingSettings settings = settingsFor(probe);
  settings.scanlines = kLines, settings.samples = kSamples, settings.conformingContact = false;
  const EnvelopeFrame without =
      render(probe, settings, sceneAround(probe, settings, 0.7, plainTable(), [](Vec3) { return kSoftTissue; }));
  for (const Label label : {kSkin, kArtery, kFat, kNerve, kVein, kThyroid, kSternocleidomastoid, kBone, kCartilage}) {
    AcousticTable table = plainTable();
    // Whatever it would wear against another tissue, there is nothing to see against its like.
    table.tissues[label].layers = {{-0.2, 0.6, 15, 0.8, 0.3}};
    table.tissues[label].vessel = label == kArtery || label == kVein;
    const auto scene = sceneAround(probe, settings, 0.7, table, [&](Vec3 p) {
      return std::hypot(p.x - 2, p.z - 15) < 6 || p.z > 28 ? label : kSoftTissue;
    });
    EXPECT_LT(relativeError(render(probe, settings, scene), without), 1e-6) << "label " << int(label);
  }
}

}  // namespace
}  // namespace insonate::test
