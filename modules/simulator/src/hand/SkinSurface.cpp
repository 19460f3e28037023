#include "hand/SkinSurface.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace insonate {
namespace {

constexpr double kNode_mm = 2;
constexpr double kSmoothing_mm = 1.4;  // SD, in addition to the mean over a node
constexpr double kFootprint_mm = 6;    // additional SD of the smoothing for normals

/// Eight nodes around a place; the nodes at the edge continue outside.
struct Cell {
  int low[3], high[3];
  double f[3];
};

Cell cellAt(const std::array<int, 3>& size, Vec3 node) {
  Cell cell;
  for (int a = 0; a < 3; ++a) {
    const double at = std::clamp(node[a], 0.0, size[a] - 1.0);
    cell.low[a] = std::min(static_cast<int>(at), std::max(size[a] - 2, 0));
    cell.high[a] = std::min(cell.low[a] + 1, size[a] - 1);
    cell.f[a] = at - cell.low[a];
  }
  return cell;
}

}  // namespace

Result<SkinSurface> SkinSurface::make(const LabelMap& labels) {
  const VolumeGeometry& grid = labels.geometry;
  if (auto ok = validate(grid); !ok) return tl::unexpected(ok.error());
  if (labels.voxels.size() != grid.voxelCount())
    return fail("The number of voxels in the label map does not match its size.");
  SkinSurface skin;
  Transform indexFromNode;
  for (int a = 0; a < 3; ++a) {
    const int parts = std::max(1, static_cast<int>(std::lround(kNode_mm / grid.spacing_mm[a])));
    skin.voxels_[a] = grid.size[a];
    skin.parts_[a] = parts;
    skin.size_[a] = (grid.size[a] + parts - 1) / parts;
    skin.spacing_mm_[a] = parts * grid.spacing_mm[a];
    indexFromNode.linear.column[a] = indexFromNode.linear.column[a] * parts;
    indexFromNode.offset[a] = 0.5 * (parts - 1);
  }
  skin.patientFromNode_ = grid.patientFromIndex() * indexFromNode;
  skin.nodeFromPatient_ = inverted(skin.patientFromNode_);
  skin.average(labels);
  skin.fillPockets();
  skin.smooth(kSmoothing_mm, skin.body_);
  skin.footprint_ = skin.body_;
  skin.smooth(kFootprint_mm, skin.footprint_);
  skin.collect();
  if (skin.skin_.empty())
    return fail("There is no skin in the label map: it is all background or all body. Label the body first.");
  return skin;
}

/// Share of body in each node's voxels.
void SkinSurface::average(const LabelMap& labels) {
  body_.resize(offset(0, 0, size_[2]));
  tbb::parallel_for(0, size_[2], [&](int k) {
    for (int j = 0; j < size_[1]; ++j)
      for (int i = 0; i < size_[0]; ++i) {
        const int node[] = {i, j, k};
        int first[3], end[3];
        for (int a = 0; a < 3; ++a) {
          first[a] = node[a] * parts_[a];
          end[a] = std::min(first[a] + parts_[a], voxels_[a]);
        }
        int body = 0;
        for (int z = first[2]; z < end[2]; ++z)
          for (int y = first[1]; y < end[1]; ++y)
            for (int x = first[0]; x < end[0]; ++x) body += labels.at(x, y, z) != 0;
        const int all = (end[0] - first[0]) * (end[1] - first[1]) * (end[2] - first[2]);
        body_[offset(i, j, k)] = static_cast<float>(body) / static_cast<float>(all);
      }
  });
}

/// Background that is not connected with the volume's edge is not outside.
void SkinSurface::fillPockets() {
  enum : std::uint8_t { kUnseen, kOutside };
  std::vector<std::uint8_t> seen(body_.size(), kUnseen);
  std::vector<std::size_t> front;
  const auto visit = [&](std::size_t n) {
    if (seen[n] != kUnseen || body_[n] >= 0.5F) return;
    seen[n] = kOutside;
    front.push_back(n);
  };
  for (int k = 0; k < size_[2]; ++k)
    for (int j = 0; j < size_[1]; ++j) {
      const bool edge = j == 0 || j == size_[1] - 1 || k == 0 || k == size_[2] - 1;
      for (int i = 0; i < size_[0]; i += edge ? 1 : std::max(size_[0] - 1, 1)) visit(offset(i, j, k));
    }
  const std::size_t row = size_[0], slice = row * size_[1];
  while (!front.empty()) {
    const std::size_t n = front.back();
    front.pop_back();
    const auto i = n % row, j = n / row % size_[1], k = n / slice;
    if (i > 0) visit(n - 1);
    if (i + 1 < row) visit(n + 1);
    if (j > 0) visit(n - row);
    if (j + 1 < std::size_t(size_[1])) visit(n + row);
    if (k > 0) visit(n - slice);
    if (k + 1 < std::size_t(size_[2])) visit(n + slice);
  }
  // Nodes with less than half body beside the outside keep their share: the skin passes through them.
  for (std::size_t n = 0; n < body_.size(); ++n)
    if (seen[n] != kOutside && body_[n] < 0.5F) body_[n] = 1;
}

void SkinSurface::smooth(double sd_mm, std::vector<float>& share) const {
  std::vector<float> scratch(share.size());
  const std::array<std::size_t, 3> step{1, std::size_t(size_[0]), std::size_t(size_[0]) * size_[1]};
  for (int axis = 0; axis < 3; ++axis) {
    const double sd = sd_mm / spacing_mm_[axis];
    const int radius = static_cast<int>(std::ceil(3 * sd));
    std::vector<float> weight;
    float sum = 0;
    for (int o = -radius; o <= radius; ++o) weight.push_back(static_cast<float>(std::exp(-0.5 * o * o / (sd * sd))));
    for (const float w : weight) sum += w;
    tbb::parallel_for(0, size_[2], [&](int k) {
      for (int j = 0; j < size_[1]; ++j)
        for (int i = 0; i < size_[0]; ++i) {
          const int at[] = {i, j, k};
          const std::size_t n = offset(i, j, k);
          float mean = 0;
          for (int o = -radius; o <= radius; ++o) {
            const int there = std::clamp(at[axis] + o, 0, size_[axis] - 1) - at[axis];
            mean += weight[o + radius] * share[n + std::ptrdiff_t(there) * std::ptrdiff_t(step[axis])];
          }
          scratch[n] = mean / sum;
        }
    });
    share.swap(scratch);
  }
}

/// Crossings of the lattice's lines with the skin.
void SkinSurface::collect() {
  for (int k = 0; k < size_[2]; ++k)
    for (int j = 0; j < size_[1]; ++j)
      for (int i = 0; i < size_[0]; ++i) {
        const int at[] = {i, j, k};
        const float here = body_[offset(i, j, k)];
        for (int a = 0; a < 3; ++a) {
          int next[] = {i, j, k};
          if (++next[a] == size_[a]) continue;
          const float there = body_[offset(next[0], next[1], next[2])];
          if ((here < 0.5F) == (there < 0.5F)) continue;
          Vec3 node{double(at[0]), double(at[1]), double(at[2])};
          node[a] += (0.5F - here) / (there - here);
          const Vec3 p = patientFromNode_ * node;
          if (!inVolume(p)) continue;
          skin_.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
        }
      }
}

double SkinSurface::sample(const std::vector<float>& share, Vec3 node) const {
  const Cell cell = cellAt(size_, node);
  double sum = 0;
  for (int c = 0; c < 8; ++c) {
    double weight = 1;
    for (int a = 0; a < 3; ++a) weight *= c >> a & 1 ? cell.f[a] : 1 - cell.f[a];
    sum += weight * share[offset(c & 1 ? cell.high[0] : cell.low[0], c & 2 ? cell.high[1] : cell.low[1],
                                 c & 4 ? cell.high[2] : cell.low[2])];
  }
  return sum;
}

double SkinSurface::body(Vec3 patient_mm) const {
  return sample(body_, nodeFromPatient_ * patient_mm);
}

Vec3 SkinSurface::normal(Vec3 patient_mm, Vec3 before) const {
  const Vec3 node = nodeFromPatient_ * patient_mm;
  Vec3 outward;
  for (int a = 0; a < 3; ++a) {
    Vec3 step;  // one node in both directions, so that the normal changes continuously between cells
    step[a] = 1;
    const double slope_permm =
        (sample(footprint_, node - step) - sample(footprint_, node + step)) / (2 * spacing_mm_[a]);
    outward = outward + patientFromNode_.linear.column[a] * (slope_permm / spacing_mm_[a]);
  }
  // The value of a flat skin is 0.06.
  constexpr double kWeak_permm = 0.015;
  const double strength = norm(outward);
  if (strength < kWeak_permm) outward = outward + before * (kWeak_permm - strength);
  return norm(outward) > 1e-9 ? normalized(outward) : before;
}

std::optional<Vec3> SkinSurface::along(Vec3 from_mm, Vec3 outward, double reach_mm) const {
  constexpr double kStep_mm = 0.5;
  const double start = body(from_mm) - 0.5;
  const Vec3 direction = start >= 0 ? outward : -outward;
  double before = start;
  for (double s = kStep_mm; s <= reach_mm + kStep_mm; s += kStep_mm) {
    const double here = body(from_mm + direction * s) - 0.5;
    if ((here >= 0) != (start >= 0)) {
      const double at = s - kStep_mm * here / (here - before);
      return from_mm + direction * at;
    }
    before = here;
  }
  return std::nullopt;
}

Vec3 SkinSurface::nearest(Vec3 patient_mm) const {
  const auto x = static_cast<float>(patient_mm.x), y = static_cast<float>(patient_mm.y),
             z = static_cast<float>(patient_mm.z);
  float least = std::numeric_limits<float>::infinity();
  std::size_t best = 0;
  for (std::size_t n = 0; n < skin_.size(); ++n) {
    const float dx = skin_[n][0] - x, dy = skin_[n][1] - y, dz = skin_[n][2] - z;
    const float d2 = dx * dx + dy * dy + dz * dz;
    if (d2 < least) least = d2, best = n;
  }
  Vec3 found{skin_[best][0], skin_[best][1], skin_[best][2]};
  // Moves from the nearest crossing of the lattice to the nearest place between crossings.
  for (int step = 0; step < 4; ++step) {
    const Vec3 outward = normal(found, {});
    if (norm(outward) == 0) break;
    const Vec3 off = patient_mm - found;
    Vec3 aside = off - outward * dot(off, outward);
    if (norm(aside) > kNode_mm) aside = normalized(aside) * kNode_mm;
    const auto next = along(found + aside, outward, 2 * kNode_mm);
    if (!next || !inVolume(*next) || norm(patient_mm - *next) >= norm(off)) break;
    found = *next;
  }
  return found;
}

bool SkinSurface::inVolume(Vec3 patient_mm) const {
  const Vec3 node = nodeFromPatient_ * patient_mm;
  for (int a = 0; a < 3; ++a) {
    const double index = node[a] * parts_[a] + 0.5 * (parts_[a] - 1);
    if (!(index >= 0 && index <= voxels_[a] - 1)) return false;
  }
  return true;
}

}  // namespace insonate
