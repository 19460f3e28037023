#include "CastVolume.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace insonate::views {
namespace {

/// In units of the smallest voxels.
constexpr double kStep = 0.7;
constexpr float kMaxOpaque = 0.999F;

void findRanges(CastGrid& grid) {
  for (int axis = 0; axis < 3; ++axis)
    grid.blocks[axis] = (grid.size[axis] + (1 << CastGrid::kShift) - 1) >> CastGrid::kShift;
  grid.ranges.assign(grid.block(0, 0, grid.blocks[2]),
                     {std::numeric_limits<std::int16_t>::max(), std::numeric_limits<std::int16_t>::lowest()});
  const auto row = [&](int j, int k, int blockJ, int blockK) {
    const std::int16_t* voxels = grid.voxels + (std::size_t(k) * grid.size[1] + j) * grid.size[0];
    for (int i = 0; i < grid.blocks[0]; ++i) {
      const int first = i << CastGrid::kShift, last = std::min(first + (1 << CastGrid::kShift), grid.size[0] - 1);
      const auto [least, most] = std::minmax_element(voxels + first, voxels + last + 1);
      CastGrid::Range& range = grid.ranges[grid.block(i, blockJ, blockK)];
      range.least = std::min(range.least, *least), range.most = std::max(range.most, *most);
    }
  };
  // A row at the border of two blocks belongs to both, since interpolation uses the last voxel of the block before.
  const auto first = [](int at) {
    return at % (1 << CastGrid::kShift) == 0 ? std::max(0, (at >> CastGrid::kShift) - 1) : at >> CastGrid::kShift;
  };
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int blockK = first(k); blockK <= k >> CastGrid::kShift; ++blockK)
        for (int blockJ = first(j); blockJ <= j >> CastGrid::kShift; ++blockJ) row(j, k, blockJ, blockK);
}

/// Means of boxes of voxels.
void makeCopy(CastVolume& volume) {
  const VolumeGeometry& grid = volume.patient->ct.geometry;
  CastGrid& coarse = volume.coarse;
  std::array<int, 3> factor;
  for (int axis = 0; axis < 3; ++axis) {
    factor[axis] = (grid.size[axis] + CastVolume::kMaxCoarse - 1) / CastVolume::kMaxCoarse;
    coarse.size[axis] = std::max(1, grid.size[axis] / factor[axis]);
  }
  volume.copy.resize(std::size_t(coarse.size[0]) * coarse.size[1] * coarse.size[2]);
  std::vector<std::int32_t> sums(std::size_t(coarse.size[0]));
  const std::int16_t* voxels = volume.patient->ct.voxels.data();
  std::int16_t* to = volume.copy.data();
  const int count = factor[0] * factor[1] * factor[2];
  for (int k = 0; k < coarse.size[2]; ++k) {
    for (int j = 0; j < coarse.size[1]; ++j) {
      std::ranges::fill(sums, 0);
      for (int inner = 0; inner < factor[1] * factor[2]; ++inner) {
        const std::int16_t* from =
            voxels + grid.offset(0, j * factor[1] + inner % factor[1], k * factor[2] + inner / factor[1]);
        for (std::int32_t& sum : sums)
          for (int i = 0; i < factor[0]; ++i) sum += *from++;
      }
      for (const std::int32_t sum : sums) *to++ = std::int16_t(sum / count);
    }
  }
  coarse.voxels = volume.copy.data();
  // The center of a box of f voxels is (f - 1) / 2 after its first voxel.
  Transform coarseFromFine;
  coarse.finest_mm = std::numeric_limits<double>::max();
  for (int axis = 0; axis < 3; ++axis) {
    const double f = factor[axis];
    coarseFromFine.linear.column[axis] = coarseFromFine.linear.column[axis] * (1 / f);
    coarseFromFine.offset[axis] = -(f - 1) / 2 / f;
    coarse.finest_mm = std::min(coarse.finest_mm, f * grid.spacing_mm[axis]);
  }
  coarse.indexFromPatient = coarseFromFine * grid.indexFromPatient();
}

}  // namespace

std::shared_ptr<const CastVolume> makeCastVolume(std::shared_ptr<const PatientCase> patient) {
  auto volume = std::make_shared<CastVolume>();
  volume->patient = std::move(patient);
  const VolumeGeometry& grid = volume->patient->ct.geometry;
  CastGrid& fine = volume->fine;
  fine.size = {grid.size[0], grid.size[1], grid.size[2]};
  fine.voxels = volume->patient->ct.voxels.data();
  fine.indexFromPatient = grid.indexFromPatient();
  fine.finest_mm = std::min({grid.spacing_mm.x, grid.spacing_mm.y, grid.spacing_mm.z});
  findRanges(fine);
  makeCopy(*volume);
  findRanges(volume->coarse);
  return volume;
}

int CastLook::entryOf(int hu) {
  return std::clamp(hu - kFirst_HU, 0, kEntries - 1);
}

CastLook::CastLook(std::shared_ptr<const CastVolume> of, const TransferFunction& function) : volume(std::move(of)) {
  std::vector<Entry> entries(kEntries);      // with the opacity for a millimeter
  std::vector<int> before(kEntries + 1, 0);  // number of visible entries before this one
  for (std::size_t k = 0; k < kEntries; ++k) {
    const double hu = kFirst_HU + double(k);
    const Color color = function.colorAt(hu);
    entries[k] = {float(color.red) / 255, float(color.green) / 255, float(color.blue) / 255,
                  std::min(float(function.opacityAt(hu)), kMaxOpaque)};
    before[k + 1] = before[k] + (entries[k].opacity > 0);
  }
  for (const auto& [level, grid] : {std::pair{&fine, &volume->fine}, std::pair{&coarse, &volume->coarse}}) {
    level->step_mm = kStep * grid->finest_mm;
    level->entries = entries;
    for (Entry& entry : level->entries) entry.opacity = 1 - std::pow(1 - entry.opacity, float(level->step_mm));
    level->seen.resize(grid->ranges.size());
    std::ranges::transform(grid->ranges, level->seen.begin(), [&](CastGrid::Range range) {
      return before[std::size_t(entryOf(range.most)) + 1] > before[std::size_t(entryOf(range.least))];
    });
  }
}

}  // namespace insonate::views
