#pragma once

#include "support/LabelPhantom.h"

#include <insonate/ultrasound/Engine.h>

#include <gtest/gtest.h>

#include <memory>
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
                         const AcousticScene& scene, const Transform& patientFromProbe = {});

/// A turn about an axis through a point of the probe frame, right-handed.
Transform turned(Vec3 axis, double angle_deg, Vec3 about_mm = {});
Transform moved(Vec3 by_mm);

/// Tests that every engine must pass; the parameter is its name.
class EngineTest : public testing::TestWithParam<std::string> {
 protected:
  EnvelopeFrame render(const Probe& probe, const ImagingSettings& settings, const ScenePtr& scene,
                       const Transform& patientFromProbe = {}) const {
    return renderWith(GetParam(), probe, settings, *scene, patientFromProbe);
  }
  /// Into the test report, so that figures can be read and compared.
  static void record(const std::string& what, double value);
};

std::string engineTestName(const testing::TestParamInfo<std::string>& info);

}  // namespace insonate::test

#define INSONATE_FOR_ALL_ENGINES(Suite) \
  INSTANTIATE_TEST_SUITE_P(Engines, Suite, testing::ValuesIn(insonate::engineNames()), insonate::test::engineTestName)
