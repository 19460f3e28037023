#include "SliceLabels.h"

#include "Noise.h"

#include <algorithm>
#include <cmath>

namespace insonate::phantom {
namespace {

constexpr double kFascia_mm = 0.9;   ///< mean thickness between two muscles: both sheaths and the tissue between them
constexpr double kSheath_mm = 0.35;  ///< around a muscle beside fat
/// Share by which a vein yields to a muscle at the same place.
constexpr double kYields = 0.3;

/// Noise whose structures are longer along the neck, as are sheets, fibers and vessels.
double stretched(Vec3 p_mm, double cell_mm, std::uint32_t seed, double longer = 2.2) {
  return smoothNoise({p_mm.x / cell_mm, p_mm.y / cell_mm, p_mm.z / (longer * cell_mm)}, seed);
}

/// Factor on a thickness, of mean 1 and the given SD, at least 0: the thickness of connective tissue varies, so that
/// its two faces are not parallel.
double uneven(Vec3 p_mm, double cell_mm, double amount, std::uint32_t seed) {
  return std::max(0.0, 1 + amount / kSmoothNoiseSd * stretched(p_mm, cell_mm, seed, 1.4));
}

/// Thickness of a sheet of connective tissue, or 0 where it is too thin for the voxels of a case: as labels it would be
/// a row of separate grains there.
double drawn_mm(double thickness_mm) {
  constexpr double kThinnest_mm = 0.6;
  return thickness_mm < kThinnest_mm ? 0 : thickness_mm;
}

/// Distance to the nearest of equally spaced sheets.
double toSheet_mm(double across_mm, double spacing_mm) {
  const double turn = across_mm / spacing_mm;
  return std::abs(turn - std::round(turn)) * spacing_mm;
}

/// Union of two sheets by the distances to their faces; it fills the corner where they meet.
double merged_mm(double a_mm, double b_mm) {
  constexpr double kCorner_mm = 0.8;
  const double near = std::max(0.0, 1 - std::abs(a_mm - b_mm) / kCorner_mm);
  return std::min(a_mm, b_mm) - kCorner_mm / 4 * near * near;
}

}  // namespace

SliceLabels::SliceLabels(std::span<const Structure> structures, BodySurface::Slice body, const Platysma& platysma,
                         SliceGrid grid)
    : structures_(structures),
      body_(std::move(body)),
      platysma_(platysma),
      grid_(grid),
      voxels_(std::size_t(grid.width) * grid.height) {}

void SliceLabels::place(const std::function<Vec3(Vec3)>& modelFromPatient) {
  // The warp varies over centimeters; it is sampled every 8 voxels and interpolated.
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
    double d = section.distance_mm(voxel.site);
    if (s.kind == Kind::kVein) d += kYields * std::max(0.0, -voxel.muscle_mm);
    if (s.label != kNerve && s.label != kLymphNode) voxel.organ_mm = std::min(voxel.organ_mm, d);
    if (d < 0 && mayEnter) {
      voxel.organ = s.label;
    } else if (d < 1.7 * s.sheath_mm && d < s.sheath_mm * uneven(voxel.site.p_mm, 6, 0.35, grid_.seed ^ 0x5ea8U)) {
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

bool SliceLabels::isPlatysma(const Site& s, double fat_mm) const {
  const double side = std::abs(s.angle), first = platysma_.first + 0.006 * std::max(0.0, s.p_mm.z);
  if (side < first || side > platysma_.last || s.p_mm.z > platysma_.top_z_mm) return false;
  const double lift = 0.3 * stretched(s.p_mm, 15, grid_.seed ^ 0x97U) + 0.12 * stretched(s.p_mm, 6, grid_.seed ^ 0x96U);
  const double height_mm = -s.belowFascia_mm - fat_mm * std::max(0.0, platysma_.height + lift);
  const double edge = std::min({1.0, (side - first) / 0.15, (platysma_.last - side) / 0.3});
  // Its bundles separate in places.
  const double gaps = std::clamp(1.6 + 3 * stretched(s.p_mm, 10, grid_.seed ^ 0x99U), 0.0, 1.0);
  return std::abs(height_mm) < platysma_.halfThickness_mm * edge * gaps * uneven(s.p_mm, 7, 0.3, grid_.seed ^ 0x98U);
}

std::uint8_t SliceLabels::superficial(const Voxel& v) const {
  const Site& s = v.site;
  if (s.belowSkin_mm < s.skin_mm) return kSkin;
  if (v.organ) return v.organ;
  const double fat_mm = s.belowSkin_mm - s.belowFascia_mm - s.skin_mm;
  if (isPlatysma(s, fat_mm)) return kMuscle;
  if (-s.belowFascia_mm < drawn_mm(0.45 * uneven(s.p_mm, 9, 0.8, grid_.seed ^ 0x5f1U))) return kSoftTissue;
  // The superficial fascia: an interrupted sheet that rises from the deep fascia to the skin and returns.
  const double height = 0.55 + 0.6 * stretched(s.p_mm, 19, grid_.seed ^ 0x91U);
  const double half_mm = drawn_mm(0.6 * uneven(s.p_mm, 10, 1.1, grid_.seed ^ 0x92U)) / 2;
  return std::abs(-s.belowFascia_mm - height * fat_mm) < half_mm ? kSoftTissue : kFat;
}

std::uint8_t SliceLabels::filling(const Voxel& v) const {
  const Vec3& p = v.site.p_mm;
  const double below_mm = v.site.belowFascia_mm;
  if (v.muscle_mm < drawn_mm(kSheath_mm * uneven(p, 7, 0.9, grid_.seed ^ 0x5ea7U)) ||
      below_mm < drawn_mm(0.45 * uneven(p, 9, 0.9, grid_.seed ^ 0x5f2U)))
    return kSoftTissue;
  // Long, flat fat pads between sheets along the skin, others that cross these at a flat angle, and some that wrap
  // muscles, vessels and glands. Each fades in and out separately. There are more around the airway than at the side.
  const double medial_mm = 0.16 * std::clamp((34 - std::abs(p.x)) / 20, 0.0, 1.0);
  const auto half_mm = [&](double cell_mm, std::uint32_t key) {
    return drawn_mm((0.48 + 2 * medial_mm) * uneven(p, cell_mm, 1.1, grid_.seed ^ key)) / 2;
  };
  const double along_mm = toSheet_mm(below_mm + 2.6 * stretched(p, 18, grid_.seed ^ 0xfa7U), 5);
  const double aslant_mm = toSheet_mm(below_mm + 5.5 * stretched(p, 27, grid_.seed ^ 0xfa8U) + 0.12 * p.x, 8.5);
  const double around_mm = std::abs(std::min(v.muscle_mm, v.organ_mm) - 1.9 - stretched(p, 10, grid_.seed ^ 0xfa9U));
  return merged_mm(merged_mm(along_mm - half_mm(14, 0xfaaU), aslant_mm - half_mm(18, 0xfabU)),
                   around_mm - 0.8 * half_mm(11, 0xfacU)) < 0
             ? kSoftTissue
             : kFat;
}

std::uint8_t SliceLabels::label(const Voxel& v) const {
  const Site& s = v.site;
  if (s.belowSkin_mm <= 0) return kBackground;
  if (s.belowFascia_mm < 0) return superficial(v);
  if (v.organ) return v.organ;
  if (v.arterial || v.venous || v.walled) return kSoftTissue;
  if (v.muscle_mm < 0) {
    const double gap = drawn_mm(kFascia_mm * uneven(s.p_mm, 7, 0.6, grid_.seed ^ 0xfa5U));
    return v.nextMuscle_mm - v.muscle_mm < gap ? std::uint8_t(kSoftTissue) : v.muscle;
  }
  return filling(v);
}

void SliceLabels::paint(std::uint8_t* labels) {
  // Muscles precede veins, which yield to them.
  for (const bool muscles : {true, false})
    for (const Structure& s : structures_)
      if ((s.kind == Kind::kMuscle) == muscles)
        if (auto section = s.shape(body_, grid_.z_mm)) muscles ? addMuscle(s, *section) : addOrgan(s, *section);
  for (std::size_t n = 0; n < voxels_.size(); ++n) labels[n] = label(voxels_[n]);
}

}  // namespace insonate::phantom
