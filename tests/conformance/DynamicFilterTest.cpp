#include "conformance/Measure.h"
#include "conformance/Rig.h"

namespace insonate::test {
namespace {

class DynamicFilter : public EngineTest {};
INSONATE_FOR_ALL_ENGINES(DynamicFilter);

ImagingSettings filtered(ImagingSettings settings, double dynamicFilter) {
  settings.dynamicFilter = dynamicFilter;
  return settings;
}

/// Axial width of a point's image at half maximum, mm.
double pointLength_mm(const std::string& engine, double depth_mm, double dynamicFilter) {
  const Probe probe = probeNamed("linear");
  const ImagingSettings settings = filtered(silentSettings(probe, 193, 1600), dynamicFilter);
  const LabelPhantom phantom =
      paint(alignedGridOver(regionAround(probe, settings, {}, 1), 1), [](Vec3) { return kSoftTissue; });
  const ScenePtr scene =
      sceneOf(phantom, plainTable(), regionAround(probe, settings, {}, 0.5), {{{0, 0, depth_mm}, 1}});
  const EnvelopeFrame frame = renderWith(engine, probe, settings, *scene);
  return peakOf(scanline(frame, 96)).fwhm * BeamGrid(probe, settings).step_mm();
}

TEST_P(DynamicFilter, LengthensThePulseWithDepth) {
  const double plain_mm = pointLength_mm(GetParam(), 30, 0);
  record("pulse at 30 mm without it, mm", plain_mm);
  EXPECT_NEAR(pointLength_mm(GetParam(), 30, 1) / plain_mm, 2, 0.1);
  EXPECT_NEAR(pointLength_mm(GetParam(), 15, 1) / plain_mm, 1.5, 0.08);
}

TEST_P(DynamicFilter, KeepsTheLevelOfSpeckle) {
  const Probe probe = probeNamed("linear");
  const auto level = [&](double dynamicFilter) {
    const ImagingSettings settings = filtered(speckleSettings(probe, 192, 1000, 3), dynamicFilter);
    const ScenePtr scene = evenScene(probe, settings);
    return rms(valuesIn(render(probe, settings, scene), {600, 950, 20, 172}));
  };
  EXPECT_NEAR(decibel(level(1) / level(0)), 0, 0.5);
}

TEST_P(DynamicFilter, KeepsTheLevelOfAReflector) {
  const Probe probe = probeNamed("linear");
  AcousticTable table = plainTable();
  table.tissues[kMuscle].impedance_MRayl = 1.7;
  const auto level = [&](double dynamicFilter) {
    ImagingSettings settings = filtered(silentSettings(probe, 96, 1000), dynamicFilter);
    settings.effects.reflection = true;
    const ScenePtr scene =
        sceneAround(probe, settings, 0.7, table, [](Vec3 p) { return p.z < 28 ? kSoftTissue : kMuscle; });
    return peakOf(scanline(render(probe, settings, scene), 48)).value;
  };
  EXPECT_NEAR(level(1) / level(0), 1, 0.05) << "its place between samples decides the rest";
}

}  // namespace
}  // namespace insonate::test
