#include "SliceLabels.h"

#include "Noise.h"

#include <algorithm>
#include <cmath>

namespace insonate::phantom {
namespace {

constexpr double kFascia_mm = 1.2;  ///< between two muscles, both sheaths and what lies between
constexpr double kSheath_mm = 0.5;  ///< about a muscle, beside fat

/// Connective tissue is thick in one place and hardly there in the next, so that its two faces are never parallel.
double uneven(Vec3 p_mm, double cell_mm, double amount, std::uint32_t seed) {
  return 1 + amount / kSmoothNoiseSd * smoothNoise(p_mm / cell_mm, seed);
}

}  // namespace

SliceLabels::SliceLabels(std::span<const Structure> structures, BodySurface::Slice body, SliceGrid grid)
    : structures_(structures), body_(std::move(body)), grid_(grid), voxels_(std::size_t(grid.width) * grid.height) {}

void SliceLabels::place(const std::function<Vec3(Vec3)>& modelFromPatient) {
  // The warp varies over centimetres: sampled every 8 voxels and interpolated.
  constexpr int kStep = 8;
  const int nx = (grid_.width - 1) / kStep + 2, ny = (grid_.height - 1) / kStep + 2;
  std::vector<Vec3> coarse(std::size_t(nx) * ny);
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i)
      coarse[std::size_t(j) * nx + i] =
          modelFromPatient({grid_.origin_mm.x + i * kStep * grid_.spacing_mm.x,
                            grid_.origin_mm.y + j * kStep * grid_.spacing_mm.y, grid_.z_mm});
  for (int j = 0; j < grid_.height; ++j)
    for (int i = 0; i < grid_.width; ++i) {
      const int ci = i / kStep, cj = j / kStep;
      const double u = double(i % kStep) / kStep, v = double(j % kStep) / kStep;
      const Vec3* c = &coarse[std::size_t(cj) * nx + ci];
      const Vec3 p = (c[0] * (1 - u) + c[1] * u) * (1 - v) + (c[nx] * (1 - u) + c[nx + 1] * u) * v;
      voxels_[std::size_t(j) * grid_.width + i].site = body_.site(p);
    }
  makeTiles();
}

void SliceLabels::makeTiles() {
  constexpr int kTile = 16;
  for (int j = 0; j < grid_.height; j += kTile)
    for (int i = 0; i < grid_.width; i += kTile) {
      Tile tile{i, std::min(i + kTile, grid_.width), j, std::min(j + kTile, grid_.height), {1e9, -1e9, 1e9, -1e9}};
      bool inside = false;
      for (int y = tile.firstJ; y < tile.lastJ; ++y)
        for (int x = tile.firstI; x < tile.lastI; ++x) {
          const Site& s = voxels_[std::size_t(y) * grid_.width + x].site;
          inside = inside || s.belowSkin_mm > 0;
          Box2& b = tile.bounds_mm;
          b = {std::min(b.minX, s.p_mm.x), std::max(b.maxX, s.p_mm.x), std::min(b.minY, s.p_mm.y),
               std::max(b.maxY, s.p_mm.y)};
        }
      if (inside) tiles_.push_back(tile);
    }
}

template <class Visit>
void SliceLabels::within(const Section& section, Visit visit) {
  const Box2& b = section.bounds_mm;
  for (const Tile& tile : tiles_) {
    const Box2& t = tile.bounds_mm;
    if (t.maxX < b.minX || t.minX > b.maxX || t.maxY < b.minY || t.minY > b.maxY) continue;
    for (int j = tile.firstJ; j < tile.lastJ; ++j)
      for (int i = tile.firstI; i < tile.lastI; ++i) {
        Voxel& voxel = voxels_[std::size_t(j) * grid_.width + i];
        const Vec3& p = voxel.site.p_mm;
        if (p.x >= b.minX && p.x <= b.maxX && p.y >= b.minY && p.y <= b.maxY && voxel.site.belowSkin_mm > 0)
          visit(voxel);
      }
  }
}

void SliceLabels::addOrgan(const Structure& s, const Section& section) {
  within(section, [&](Voxel& voxel) {
    if (voxel.organ) return;
    const bool mayEnter = s.kind == Kind::kArtery ||
                          (s.kind == Kind::kVein ? !voxel.arterial : !voxel.arterial && !voxel.venous && !voxel.walled);
    const double d = section.distance_mm(voxel.site);
    if (d < 0 && mayEnter) {
      voxel.organ = s.label;
    } else if (d < s.sheath_mm) {
      (s.kind == Kind::kArtery ? voxel.arterial : s.kind == Kind::kVein ? voxel.venous : voxel.walled) = true;
    }
  });
}

void SliceLabels::addMuscle(const Structure& s, const Section& section) {
  within(section, [&](Voxel& voxel) {
    const double d = section.distance_mm(voxel.site);
    if (d < voxel.muscle_mm) {
      voxel.nextMuscle_mm = voxel.muscle_mm;
      voxel.muscle_mm = d;
      voxel.muscle = s.label;
    } else if (d < voxel.nextMuscle_mm) {
      voxel.nextMuscle_mm = d;
    }
  });
}

std::uint8_t SliceLabels::superficial(const Voxel& v, double layers_mm) const {
  const Site& s = v.site;
  const double skin = BodySurface::kSkin_mm * (1 + 0.12 * smoothNoise(s.p_mm / 9, grid_.seed ^ 0x5b1U));
  if (s.belowSkin_mm < skin) return kSkin;
  if (v.organ) return v.organ;
  // Platysma: a thin sheet low in the fat, from beside the midline to the lateral neck, over the clavicle.
  const double side = std::abs(s.angle), fat = layers_mm - skin;
  const double fromMidline = 0.12 + 0.006 * std::max(0.0, s.p_mm.z);
  if (side > fromMidline && side < 1.75 && s.p_mm.z < 46) {
    const double height = -s.belowFascia_mm - 0.24 * fat - 0.6 * smoothNoise(s.p_mm / 11, grid_.seed ^ 0x97U);
    const double thin = std::min({1.0, (side - fromMidline) / 0.1, (1.75 - side) / 0.25});
    if (std::abs(height) < 0.55 * thin * uneven(s.p_mm, 7, 0.35, grid_.seed ^ 0x98U)) return kMuscle;
  }
  if (s.belowFascia_mm > -0.4 * uneven(s.p_mm, 8, 0.5, grid_.seed ^ 0x5f1U)) return kSoftTissue;
  return kFat;
}

std::uint8_t SliceLabels::filling(const Voxel& v) const {
  const Site& s = v.site;
  const double sheath = kSheath_mm * uneven(s.p_mm, 6, 0.5, grid_.seed ^ 0x5ea7U);
  if (v.muscle_mm < sheath || s.belowFascia_mm < 0.6 * uneven(s.p_mm, 9, 0.5, grid_.seed ^ 0x5f2U)) return kSoftTissue;
  // Fat pads in connective tissue; more fat to the side and back than about the airway.
  const double lateral = std::clamp((std::abs(s.p_mm.x) - 18) / 20, 0.0, 1.0);
  const double pads =
      smoothNoise(s.p_mm / 6.5, grid_.seed ^ 0xfa7U) + 0.5 * smoothNoise(s.p_mm / 2.7, grid_.seed ^ 0xfa8U);
  return pads > 0.12 - 0.5 * lateral ? kFat : kSoftTissue;
}

std::uint8_t SliceLabels::label(const Voxel& v) const {
  const Site& s = v.site;
  if (s.belowSkin_mm <= 0) return kBackground;
  if (s.belowFascia_mm < 0) return superficial(v, s.belowSkin_mm - s.belowFascia_mm);
  if (v.organ) return v.organ;
  if (v.arterial || v.venous || v.walled) return kSoftTissue;
  if (v.muscle_mm < 0) {
    const double gap = kFascia_mm * uneven(s.p_mm, 5, 0.3, grid_.seed ^ 0xfa5U);
    return v.nextMuscle_mm - v.muscle_mm < gap ? std::uint8_t(kSoftTissue) : v.muscle;
  }
  return filling(v);
}

void SliceLabels::paint(std::uint8_t* labels) {
  for (const Structure& s : structures_)
    if (auto section = s.shape(body_, grid_.z_mm)) {
      if (s.kind == Kind::kMuscle)
        addMuscle(s, *section);
      else
        addOrgan(s, *section);
    }
  for (std::size_t n = 0; n < voxels_.size(); ++n) labels[n] = label(voxels_[n]);
}

}  // namespace insonate::phantom
