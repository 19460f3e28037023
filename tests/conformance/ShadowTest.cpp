#include "conformance/Measure.h"
#include "conformance/Rig.h"

#include <cmath>

namespace insonate::test {
namespace {

class Shadow : public EngineTest {};
INSONATE_FOR_ALL_ENGINES(Shadow);

/// A round bar across the slice: its shadow lies between the rays that touch it.
struct Bar {
  const char* probe;
  double depth_mm;  ///< of the frame
  double lateral_mm, axial_mm, radius_mm, voxel_mm;

  bool holds(Vec3 p) const { return std::hypot(p.x - lateral_mm, p.z - axial_mm) < radius_mm; }
};
const std::vector<Bar> kBars{
    {"linear", 40, -1.3, 14, 6, 0.5}, {"curvilinear", 60, -3, 24, 8, 0.5}, {"phased", 60, -3, 24, 8, 0.5}};

/// Scanlines between which straight rays meet the bar.
std::pair<double, double> geometricEdges(const Probe& probe, const BeamGrid& grid, const Bar& bar) {
  if (probe.shape == ProbeShape::Linear)
    return {grid.locate(bar.lateral_mm - bar.radius_mm, bar.axial_mm).scanline,
            grid.locate(bar.lateral_mm + bar.radius_mm, bar.axial_mm).scanline};
  const double fromApex_mm = bar.axial_mm + probe.faceRadius_mm;
  const double middle = std::atan2(bar.lateral_mm, fromApex_mm);
  const double half = std::asin(bar.radius_mm / std::hypot(bar.lateral_mm, fromApex_mm));
  const auto scanlineAt = [&](double angle) {
    return grid.locate(10 * std::sin(angle), 10 * std::cos(angle) - probe.faceRadius_mm).scanline;
  };
  return {scanlineAt(middle - half), scanlineAt(middle + half)};
}

struct Edges {
  double first, last, deepest;  ///< scanlines; share of the level beside that is left behind
};

/// Half-amplitude places of the envelope averaged over depth, well behind the object.
Edges measuredEdges(const EnvelopeFrame& frame, double middle) {
  const Window below{int(0.75 * frame.samples), int(0.95 * frame.samples), 0, frame.scanlines};
  const auto profile = lineMeans(frame, below);
  const int inShadow = int(std::lround(middle));
  EXPECT_NEAR(profile[24], 1, 0.02) << "beside, at the end of the penumbra";
  const double half = (1 + profile[inShadow]) / 2;
  return {crossing(profile, half, inShadow, 0), crossing(profile, half, inShadow, frame.scanlines - 1),
          profile[inShadow]};
}

TEST_P(Shadow, EdgesLieOnStraightRaysForEveryProbe) {
  for (const Bar& bar : kBars)
    for (const bool gas : {false, true}) {
      const Probe probe = probeNamed(bar.probe);
      ImagingSettings settings = uniformSettings(probe, 256, 300, 3);
      settings.depth_mm = bar.depth_mm;
      settings.effects.transmission = true;
      AcousticTable table = plainTable();
      table.tissues[kBone].impedance_MRayl = gas ? 0.0004 : 60;
      table.tissues[kBone].echogenicity_dB = -60;
      const auto scene =
          sceneAround(probe, settings, bar.voxel_mm, table, [&](Vec3 p) { return bar.holds(p) ? kBone : kSoftTissue; });
      const auto [first, last] = geometricEdges(probe, BeamGrid(probe, settings), bar);
      const Edges edges = measuredEdges(render(probe, settings, scene), (first + last) / 2);
      const double z = table.tissues[kBone].impedance_MRayl, r = (z - 1.6) / (z + 1.6);
      const std::string what = std::string(bar.probe) + (gas ? "_gas" : "_bone");
      EXPECT_NEAR(edges.deepest, std::pow(1 - r * r, 2), 0.02) << what;
      EXPECT_NEAR(edges.first, first, 1) << what;
      EXPECT_NEAR(edges.last, last, 1) << what;
      record(what + "_first_edge_off_scanlines", edges.first - first);
      record(what + "_last_edge_off_scanlines", edges.last - last);
    }
}

/// Width over which the level rises from a fifth to four fifths of the level beside an edge.
double penumbra_mm(const EnvelopeFrame& frame, const BeamGrid& grid, double depth_mm, int dark, int bright) {
  const int sample = int(std::lround(grid.sampleAt(depth_mm)));
  const auto profile = lineMeans(frame, {sample - 5, sample + 5, 0, frame.scanlines});
  const auto at = [&](double level) { return crossing(profile, level, dark, bright); };
  return (at(0.8) - at(0.2)) * grid.scanlineSpacing_mm(depth_mm);
}

/// An aperture of depth over F sees past an edge: behind it, the border of the shadow opens as the cone of rays does.
TEST_P(Shadow, HasAPenumbraThatWidensBehindTheEdge) {
  const Probe probe = probeNamed("linear");
  ImagingSettings settings = uniformSettings(probe, 256, 300, 3);
  settings.effects.attenuation = true;
  AcousticTable table = plainTable();
  table.tissues[kBone].attenuation_dBpcmMHz = 60;
  const auto scene = sceneAround(probe, settings, 0.5, table,
                                 [](Vec3 p) { return p.z > 8 && p.z < 11 && p.x < 0 ? kBone : kSoftTissue; });
  const BeamGrid grid(probe, settings);
  const EnvelopeFrame frame = render(probe, settings, scene);
  // A fifth of a triangle of unit half base lies beyond 1 - sqrt(0.4).
  const double cone = 2 * (1 - std::sqrt(0.4)) * 0.25 * (1 / probe.transmitFNumber + 1 / probe.receiveFNumber);
  for (const double depth_mm : {20.0, 36.0}) {
    const double expected_mm = cone * (depth_mm - 9.5);
    EXPECT_NEAR(penumbra_mm(frame, grid, depth_mm, 60, 250) / expected_mm, 1, 0.25) << depth_mm;
  }
}

TEST_P(Shadow, AttenuatingBlockCastsAShadowOfItsOwnEdges) {
  const Probe probe = probeNamed("linear");
  ImagingSettings settings = uniformSettings(probe, 256, 300, 3);
  settings.effects.attenuation = true;
  AcousticTable table = plainTable();
  table.tissues[kCartilage].attenuation_dBpcmMHz = 3;
  // Sides along the beam, on voxel faces. It is thin, so that all rays of the middle scanline cross it.
  const auto scene = sceneAround(probe, settings, 0.5, table, [](Vec3 p) {
    return p.z > 16 && p.z < 20 && p.x > -6.5 && p.x < 4.5 ? kCartilage : kSoftTissue;
  });
  const BeamGrid grid(probe, settings);
  const double first = grid.locate(-6.5, 10).scanline, last = grid.locate(4.5, 10).scanline;
  const Edges edges = measuredEdges(render(probe, settings, scene), (first + last) / 2);
  EXPECT_NEAR(edges.deepest / std::pow(10, -2 * 3 * settings.frequency_MHz * 0.4 / 20), 1, 0.1);
  EXPECT_NEAR(edges.first, first, 1);
  EXPECT_NEAR(edges.last, last, 1);
  record("first_edge_off_scanlines", edges.first - first);
  record("last_edge_off_scanlines", edges.last - last);
}

}  // namespace
}  // namespace insonate::test
