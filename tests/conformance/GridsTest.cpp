#include "conformance/Measure.h"
#include "conformance/Rig.h"

#include <cmath>
#include <functional>

namespace insonate::test {
namespace {

/// The image must not depend on how the patient was cut into voxels.
class Grids : public EngineTest {
 protected:
  Probe probe_ = probeNamed("linear");
  ImagingSettings settings_ = uniformSettings(probe_, 128, 400, 3);
  AcousticTable table_ = plainTable();

  Grids() {
    for (AcousticTissue& tissue : table_.tissues) tissue.attenuation_dBpcmMHz = 0.6;
    table_.tissues[kVein].echogenicity_dB = -20, table_.tissues[kVein].attenuation_dBpcmMHz = 0.18;
    settings_.effects.attenuation = true;
  }
  EnvelopeFrame frameOn(const VolumeGeometry& grid, const std::function<Label(Vec3)>& labelAt,
                        const Transform& pose = {}) {
    return render(probe_, settings_, sceneOf(paint(grid, labelAt), table_, regionAround(probe_, settings_)), pose);
  }
};
INSONATE_FOR_ALL_ENGINES(Grids);

/// A vessel 14 mm across through (2, 0, 18) along `axis`.
std::function<Label(Vec3)> vesselAlong(Vec3 axis) {
  return [a = normalized(axis)](Vec3 p) {
    const Vec3 d = p - Vec3{2, 0, 18};
    return norm(d - a * dot(a, d)) < 7 ? kVein : kSoftTissue;
  };
}

/// A grid of the spacing whose axes are those of the turn, centred where the frame is.
VolumeGeometry gridAlong(const Mat3& direction, Vec3 spacing_mm, Vec3 extent_mm) {
  VolumeGeometry grid = gridOver({0, 0, 0}, extent_mm, spacing_mm);
  grid.direction = direction;
  grid.origin_mm = {0, 0, 0};
  grid.origin_mm = Vec3{0, 0, 18} - grid.center_mm();
  return grid;
}

const VolumeGeometry kFine = gridOver({-28, -12, -16}, {28, 12, 56}, 0.4);

/// Share of the frame that differs by more than a tenth of the tissue's level, and the mean difference.
struct Difference {
  double mean, beyond;
};
Difference differenceOf(const EnvelopeFrame& a, const EnvelopeFrame& b) {
  Difference d{0, 0};
  for (std::size_t n = 0; n < a.amplitude.size(); ++n) {
    const double off = std::abs(a.amplitude[n] - b.amplitude[n]) / std::max(0.1F, b.amplitude[n]);
    d.mean += off / static_cast<double>(a.amplitude.size());
    d.beyond += (off > 0.3) / static_cast<double>(a.amplitude.size());
  }
  return d;
}

TEST_P(Grids, ObliqueIsAsAxisAligned) {
  const auto vessel = vesselAlong({0.2, 1, 0.1});
  const EnvelopeFrame truth = frameOn(kFine, vessel);
  for (const auto& [name, direction] :
       {std::pair{"turned", turned({1, 2, 3}, 35).linear}, {"tilted", turned({1, 0, 0}, 20).linear}}) {
    const EnvelopeFrame frame = frameOn(gridAlong(direction, {0.7, 0.7, 0.7}, {105, 105, 105}), vessel);
    const Difference off = differenceOf(frame, truth);
    EXPECT_LT(off.mean, 0.02) << name;
    EXPECT_LT(off.beyond, 0.02) << name;
    record(std::string(name) + "_mean_difference", off.mean);
    record(std::string(name) + "_share_beyond_30_percent", off.beyond);
  }
}

TEST_P(Grids, LeftHandedIsAsRightHanded) {
  const auto vessel = vesselAlong({0.2, 1, 0.1});
  const VolumeGeometry right = gridOver({-28, -12, -16}, {28, 12, 56}, 0.7);
  VolumeGeometry left = right;
  left.direction.column[0] = -left.direction.column[0];
  left.origin_mm.x = right.origin_mm.x + (right.size[0] - 1) * right.spacing_mm.x;
  EXPECT_LT(relativeError(frameOn(left, vessel), frameOn(right, vessel)), 1e-2);
}

TEST_P(Grids, OneToOneToFiveIsAsIsotropic) {
  for (const auto& [name, axis, tolerance] :
       {std::tuple{"along_slices", Vec3{0, 1, 0}, 0.02}, {"slanted_20_degrees", Vec3{0.34, 0.94, 0}, 0.04}}) {
    const auto vessel = vesselAlong(axis);
    const EnvelopeFrame truth = frameOn(kFine, vessel);
    const VolumeGeometry thick = gridOver({-28, -15, -16}, {28, 15, 56}, {1, 5, 1});
    const Difference off = differenceOf(frameOn(thick, vessel), truth);
    EXPECT_LT(off.mean, tolerance) << name;
    EXPECT_LT(off.beyond, tolerance) << name;
    record(std::string(name) + "_mean_difference", off.mean);
    record(std::string(name) + "_share_beyond_30_percent", off.beyond);
  }
}

TEST_P(Grids, VesselsKeepTheirWidth) {
  settings_.effects.attenuation = false;
  for (const double voxel_mm : {0.5, 1.0})
    for (const double radius_mm : {3.0, 7.0}) {
      const EnvelopeFrame frame = frameOn(gridOver({-28, -12, -16}, {28, 12, 56}, voxel_mm), [=](Vec3 p) {
        return std::hypot(p.x - 2.1, p.z - 18.2) < radius_mm ? kVein : kSoftTissue;
      });
      const BeamGrid grid(probe_, settings_);
      const auto along = scanline(frame, int(std::lround(grid.locate(2.1, 18).scanline)));
      const int middle = int(grid.sampleAt(18.2));
      const double level = (along[middle] + 1) / 2;
      const double width_mm =
          (crossing(along, level, middle, settings_.samples - 1) - crossing(along, level, middle, 0)) * grid.step_mm();
      const std::string which =
          std::to_string(int(2 * radius_mm)) + "_mm_in_" + std::to_string(int(10 * voxel_mm)) + "_tenths";
      EXPECT_NEAR(width_mm, 2 * radius_mm, 0.4 * voxel_mm) << which;
      record("width_off_mm_" + which, width_mm - 2 * radius_mm);
    }
}

TEST_P(Grids, CoarserVoxelsMoveNoBoundary) {
  settings_.effects.scattering = false;
  settings_.effects.reflection = true;
  settings_.effects.attenuation = false;
  table_.tissues[kVein].impedance_MRayl = 1.7;
  const auto wallAt = [&](double spacing_mm) {
    const auto grid = gridOver({-28, -12, -16}, {28, 12, 56}, spacing_mm);
    const auto layers = [](Vec3 p) { return p.z < 20 ? kSoftTissue : kVein; };
    return (peakOf(scanline(frameOn(grid, layers), 64)).index + 0.5) * settings_.depth_mm / settings_.samples;
  };
  for (const double spacing_mm : {0.5, 1.0, 2.0, 4.0})
    EXPECT_NEAR(wallAt(spacing_mm), 20, 0.1) << spacing_mm << " mm voxels, whose faces lie on the boundary";
}

}  // namespace
}  // namespace insonate::test
