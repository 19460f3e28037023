#pragma once

#include "support/LabelPhantom.h"

#include <insonate/ultrasound/Engine.h>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace insonate::test {

using ScenePtr = std::shared_ptr<const AcousticScene>;

/// Every label the same tissue: 1.6 MRayl, no attenuation, 0 dB speckle, no layers, no texture. Tests change what they
/// are about.
AcousticTable plainTable();

Probe probeNamed(const std::string& name);
/// Nothing switched on but the beam. Neither this nor the next two press the skin: the geometry is exactly the pose's.
ImagingSettings silentSettings(const Probe& probe, int scanlines, int samples, int elevationPlanes = 1);
/// Fully developed speckle alone, one look.
ImagingSettings speckleSettings(const Probe& probe, int scanlines, int samples, int elevationPlanes = 1);
/// Uniform scattering alone: what is left is the loss along the beam.
ImagingSettings uniformSettings(const Probe& probe, int scanlines, int samples, int elevationPlanes = 1);

/// Everything a frame at this pose can see, grown by a margin.
Region regionAround(const Probe& probe, const ImagingSettings& settings, const Transform& patientFromProbe = {},
                    double margin_mm = 0);
ScenePtr sceneOf(const LabelPhantom& phantom, const AcousticTable& table, const Region& region,
                 std::vector<PointTarget> points = {});
/// A grid that holds the region, its voxel faces at multiples of the spacing.
VolumeGeometry alignedGridOver(const Region& region, double spacing_mm);
/// A scene in which labelAt(patient_mm) fills everything the frame sees at this pose, on a grid of the given spacing.
template <class LabelAt>
ScenePtr sceneAround(const Probe& probe, const ImagingSettings& settings, double spacing_mm, const AcousticTable& table,
                     const LabelAt& labelAt, const Transform& patientFromProbe = {}, double margin_mm = 1) {
  const Region region = regionAround(probe, settings, patientFromProbe, margin_mm);
  return sceneOf(paint(alignedGridOver(region, spacing_mm), labelAt), table, region);
}
/// One tissue everywhere.
ScenePtr evenScene(const Probe& probe, const ImagingSettings& settings, const AcousticTable& table = plainTable(),
                   const Transform& patientFromProbe = {}, double margin_mm = 1);

EnvelopeFrame renderWith(const std::string& engine, const Probe& probe, const ImagingSettings& settings,
                         const AcousticScene& scene, const Transform& patientFromProbe = {},
                         const PlaneDisplacement& displacement = {}, const std::optional<Needle>& needle = {});

/// Renders a frame with rods.
EnvelopeFrame renderWithRods(const std::string& engine, const Probe& probe, const ImagingSettings& settings,
                             const AcousticScene& scene, const std::vector<FlexibleRod>& rods,
                             const PlaneDisplacement& displacement = {}, const Needle* needle = nullptr);

EnvelopeFrame renderWithBubbles(const std::string& engine, const Probe& probe, const ImagingSettings& settings,
                                const AcousticScene& scene, const std::vector<Bubble>& bubbles,
                                const PlaneDisplacement& displacement = {});

/// A needle by its tip and direction (of any length) in a pose's frame, its bevel to the probe.
Needle needleAt(Vec3 tip_mm, Vec3 direction, const Transform& patientFromProbe = {});

/// A displacement over all that a frame sees, and 3 mm more: `shiftAt(x_mm, z_mm)` is the way to the rest point.
template <class ShiftAt>
PlaneDisplacement displacementOver(const Probe& probe, const ImagingSettings& settings, double step_mm,
                                   const ShiftAt& shiftAt) {
  const BeamGrid grid(probe, settings);
  PlaneDisplacement d;
  d.left_mm = grid.minLateral_mm() - 3, d.top_mm = grid.minAxial_mm() - 3, d.step_mm = step_mm;
  d.columns = static_cast<int>((grid.maxLateral_mm() + 3 - d.left_mm) / step_mm) + 2;
  d.rows = static_cast<int>((grid.maxAxial_mm() + 3 - d.top_mm) / step_mm) + 2;
  for (int k = 0; k < d.rows; ++k)
    for (int i = 0; i < d.columns; ++i)
      d.restFromDisplayed.push_back(shiftAt(d.left_mm + i * step_mm, d.top_mm + k * step_mm));
  return d;
}
inline PlaneDisplacement::Shift shiftBy(double x_mm, double z_mm) {
  return {static_cast<float>(x_mm), static_cast<float>(z_mm)};
}
/// Turned about a point of the plane, fading out over `reach_mm`.
inline PlaneDisplacement::Shift swirlAt(double x_mm, double z_mm, double aboutX_mm, double aboutZ_mm, double angle_deg,
                                        double reach_mm) {
  const double x = x_mm - aboutX_mm, z = z_mm - aboutZ_mm;
  const double angle = angle_deg / 57.29577951308232 * std::exp(-(x * x + z * z) / (reach_mm * reach_mm));
  const double c = std::cos(angle), s = std::sin(angle);
  return shiftBy(c * x - s * z - x, s * x + c * z - z);
}

/// A turn about an axis through a point of the probe frame, right-handed.
Transform turned(Vec3 axis, double angle_deg, Vec3 about_mm = {});
Transform moved(Vec3 by_mm);

/// Tests that every engine must pass; the parameter is its name.
class EngineTest : public testing::TestWithParam<std::string> {
 protected:
  /// Skips where this machine has not what the engine needs, such as OpenGL.
  void SetUp() override {
    if (auto engine = makeEngine(GetParam()); !engine) GTEST_SKIP() << engine.error().message;
  }
  EnvelopeFrame render(const Probe& probe, const ImagingSettings& settings, const ScenePtr& scene,
                       const Transform& patientFromProbe = {}, const PlaneDisplacement& displacement = {},
                       const std::optional<Needle>& needle = {}) const {
    return renderWith(GetParam(), probe, settings, *scene, patientFromProbe, displacement, needle);
  }
  /// Into the test report, so that figures can be read and compared.
  static void record(const std::string& what, double value);
};

std::string engineTestName(const testing::TestParamInfo<std::string>& info);

}  // namespace insonate::test

#define INSONATE_FOR_ALL_ENGINES(Suite) \
  INSTANTIATE_TEST_SUITE_P(Engines, Suite, testing::ValuesIn(insonate::engineNames()), insonate::test::engineTestName)
