#include "mpr/SliceSampler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace insonate::views {
namespace {

constexpr std::uint8_t kNothing = 255;
constexpr WindowLevel kGray{256, 128};
constexpr VoxelBox kProposed{{2, 3, 1}, {8, 9, 6}};

/// Axes of a grid as patient directions: as most scans, with two axes changed for each other, left-handed, and oblique.
std::vector<Mat3> directions() {
  const double c = std::cos(0.3), s = std::sin(0.3);
  return {Mat3{{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}}, Mat3{{Vec3{0, 0, -1}, Vec3{1, 0, 0}, Vec3{0, -1, 0}}},
          Mat3{{Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}}, Mat3{{Vec3{c, s, 0}, Vec3{-s, c, 0}, Vec3{0, 0, 1}}}};
}

VolumeGeometry gridAlong(const Mat3& direction) {
  VolumeGeometry grid;
  grid.size = {13, 11, 9};
  grid.spacing_mm = {0.9, 1.3, 2.1};
  grid.origin_mm = {-4, 7, 11};
  grid.direction = direction;
  return grid;
}

/// The same by the definition, a voxel of the grid at a time.
struct Expected {
  double hu = 0;
  std::uint8_t label = 0, proposed = kNothing;
  bool inside = true, atBorder = false;
};

Expected at(const CtVolume& ct, const LabelMap& labels, const LabelMap& proposal, Vec3 patient_mm) {
  const VolumeGeometry& grid = ct.geometry;
  const Vec3 index = grid.indexFromPatient() * patient_mm;
  Expected expected;
  int low[3], near[3];
  double share[3];
  for (int a = 0; a < 3; ++a) {
    expected.inside &= index[a] >= -0.5 && index[a] < grid.size[a] - 0.5;
    expected.atBorder |= std::abs(index[a] + 0.5 - std::round(index[a] + 0.5)) < 1e-9;
    const double within = std::clamp(index[a], 0.0, grid.size[a] - 1.0);
    low[a] = int(within), share[a] = within - low[a], near[a] = int(index[a] + 0.5);
  }
  if (!expected.inside) return expected;
  for (int corner = 0; corner < 8; ++corner) {
    double weight = 1;
    int voxel[3];
    for (int a = 0; a < 3; ++a) {
      const bool high = corner >> a & 1;
      weight *= high ? share[a] : 1 - share[a];
      voxel[a] = std::min(low[a] + int(high), grid.size[a] - 1);
    }
    expected.hu += weight * ct.at(voxel[0], voxel[1], voxel[2]);
  }
  expected.label = labels.at(near[0], near[1], near[2]);
  if (kProposed.contains(near[0], near[1], near[2]))
    expected.proposed =
        proposal.at(near[0] - kProposed.first[0], near[1] - kProposed.first[1], near[2] - kProposed.first[2]);
  return expected;
}

class Slices : public testing::Test {
 protected:
  /// Grey is the CT's value; label 1 paints over it wholly in red, a proposal of 2 in green.
  Slices() {
    sampler.setWindowLevel(kGray);
    sampler.setPaint(1, {{255, 0, 0}, 1, 1});
    sampler.setPaint(2, {{0, 255, 0}, 1, 1});
  }

  void fill(const VolumeGeometry& grid) {
    std::mt19937 random(7);
    ct = CtVolume(grid);
    labels = LabelMap(grid);
    for (auto& voxel : ct.voxels) voxel = std::int16_t(random() % 256);
    for (auto& voxel : labels.voxels) voxel = random() % 4 == 0;
    proposal = LabelMap(gridOf(grid, kProposed));
    for (auto& voxel : proposal.voxels) voxel = random() % 2 == 0 ? kNothing : std::uint8_t{2};
  }

  void expectAsDefined(const SlicePlane& plane) {
    std::vector<std::uint8_t> rgb(std::size_t(plane.width_px) * plane.height_px * 3, 99);
    sampler.setProposal(kProposed, &proposal);
    sampler.sample(ct, labels, plane, {0, plane.height_px}, rgb);
    for (int row = 0; row < plane.height_px; ++row)
      for (int column = 0; column < plane.width_px; ++column) {
        const std::uint8_t* pixel = rgb.data() + 3 * (std::size_t(row) * plane.width_px + column);
        const Expected expected = at(ct, labels, proposal, plane.patientFromDisplay({column + 0.5, row + 0.5}));
        if (expected.atBorder) continue;
        SCOPED_TRACE(testing::Message() << "column " << column << ", row " << row);
        if (!expected.inside) {
          ASSERT_EQ(pixel[0] + pixel[1] + pixel[2], 0);
        } else if (expected.proposed != kNothing) {
          ASSERT_GE(pixel[1], 127);
        } else if (expected.label == 1) {
          ASSERT_TRUE(pixel[0] >= 254 && pixel[1] <= 1 && pixel[2] <= 1);
        } else {
          ASSERT_NEAR(pixel[0], kGray.gray(expected.hu), 1);
        }
        ++seen;
      }
  }

  SliceSampler sampler;
  CtVolume ct;
  LabelMap labels, proposal;
  int seen = 0;
};

TEST_F(Slices, AreTrilinearWhateverTheGridsAxes) {
  for (const Mat3& direction : directions()) {
    fill(gridAlong(direction));
    for (const SliceKind kind : {SliceKind::Axial, SliceKind::Coronal, SliceKind::Sagittal})
      for (const double mm_per_px : {0.31, 2.7})
        for (const double off_mm : {0.0, 1.7, -60.0}) {
          SlicePlane plane{sliceAxes(kind), ct.geometry.center_mm(), mm_per_px, 61, 47};
          plane.center_mm = plane.center_mm + Vec3{off_mm, 0.37 * off_mm, 0.21 * off_mm};
          expectAsDefined(plane);
        }
  }
  EXPECT_GT(seen, 100'000);
}

TEST_F(Slices, OfEditedVoxelsOnlyRowsThatTheyTouchAreSampledAgain) {
  for (const Mat3& direction : directions())
    for (const SliceKind kind : {SliceKind::Axial, SliceKind::Coronal, SliceKind::Sagittal})
      for (const int outline_px : {1, 3}) {
        fill(gridAlong(direction));
        sampler.setOutlineWidth(outline_px);
        sampler.setPaint(1, {{255, 0, 0}, 0.3, 1});
        const SlicePlane plane{sliceAxes(kind), ct.geometry.center_mm(), 0.11, 97, 151};
        std::vector<std::uint8_t> kept(std::size_t(plane.width_px) * plane.height_px * 3), whole(kept.size());
        sampler.sample(ct, labels, plane, {0, plane.height_px}, kept);
        const VoxelBox edited{{6, 5, 4}, {8, 6, 5}};
        for (int i = edited.first[0]; i < edited.end[0]; ++i) labels.at(i, 5, 4) ^= 1;
        const SliceSampler::Rows rows = sampler.rowsOf(labels.geometry, edited, plane);
        EXPECT_LT(rows.end - rows.first, plane.height_px);
        sampler.sample(ct, labels, plane, rows, kept);
        sampler.sample(ct, labels, plane, {0, plane.height_px}, whole);
        EXPECT_EQ(kept, whole);
      }
}

}  // namespace
}  // namespace insonate::views
