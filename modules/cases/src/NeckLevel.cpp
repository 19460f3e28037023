#include "NeckLevel.h"

#include <cmath>
#include <limits>

namespace insonate {
namespace {

constexpr double kCell_mm = 3, kLevel_mm = 3;

struct Box {
  Vec3 low_mm, high_mm;
};

Box boxOf(const VolumeGeometry& g) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  Box box{{kInfinite, kInfinite, kInfinite}, {-kInfinite, -kInfinite, -kInfinite}};
  const Transform patientFromIndex = g.patientFromIndex();
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 index;
    for (int a = 0; a < 3; ++a) index[a] = corner >> a & 1 ? g.size[a] - 1.0 : 0.0;
    const Vec3 p = patientFromIndex * index;
    for (int a = 0; a < 3; ++a) {
      box.low_mm[a] = std::min(box.low_mm[a], p[a]);
      box.high_mm[a] = std::max(box.high_mm[a], p[a]);
    }
  }
  return box;
}

/// Finds pieces of body in one level, cell by cell.
class Slice {
 public:
  Slice(const PatientBody& body, const Box& box, double z_mm)
      : box_(box),
        columns_(static_cast<int>((box.high_mm.x - box.low_mm.x) / kCell_mm) + 1),
        rows_(static_cast<int>((box.high_mm.y - box.low_mm.y) / kCell_mm) + 1),
        inside_(static_cast<std::size_t>(columns_) * rows_) {
    for (int j = 0; j < rows_; ++j)
      for (int i = 0; i < columns_; ++i) inside_[cell(i, j)] = body.contains({x(i), box.low_mm.y + j * kCell_mm, z_mm});
  }

  BodyLevel largest(double z_mm) {
    BodyLevel best{z_mm, 0, 0};
    for (int j = 0; j < rows_; ++j)
      for (int i = 0; i < columns_; ++i) {
        if (!inside_[cell(i, j)]) continue;
        const BodyLevel piece = take(i, j, z_mm);
        if (piece.area_mm2 > best.area_mm2) best = piece;
      }
    return best;
  }

 private:
  std::size_t cell(int i, int j) const { return static_cast<std::size_t>(j) * columns_ + i; }
  double x(int i) const { return box_.low_mm.x + i * kCell_mm; }

  /// The piece around a cell, which is removed.
  BodyLevel take(int i0, int j0, double z_mm) {
    double cells = 0, sum_mm = 0;
    std::vector<std::pair<int, int>> open{{i0, j0}};
    inside_[cell(i0, j0)] = 0;
    while (!open.empty()) {
      const auto [i, j] = open.back();
      open.pop_back();
      ++cells;
      sum_mm += x(i);
      for (const auto& [u, v] : {std::pair{i - 1, j}, {i + 1, j}, {i, j - 1}, {i, j + 1}}) {
        if (u < 0 || v < 0 || u >= columns_ || v >= rows_ || !inside_[cell(u, v)]) continue;
        inside_[cell(u, v)] = 0;
        open.push_back({u, v});
      }
    }
    return {z_mm, cells * kCell_mm * kCell_mm, sum_mm / cells};
  }

  const Box& box_;
  int columns_, rows_;
  std::vector<std::uint8_t> inside_;
};

}  // namespace

std::vector<BodyLevel> bodyLevels(const PatientBody& body, const VolumeGeometry& grid) {
  const Box box = boxOf(grid);
  const double height_mm = box.high_mm.z - box.low_mm.z;
  const int count = static_cast<int>(height_mm / kLevel_mm) + 1;
  std::vector<BodyLevel> levels;
  for (int n = 0; n < count; ++n) {
    const double z_mm = box.low_mm.z + (n + 0.5) * height_mm / count;
    levels.push_back(Slice(body, box, z_mm).largest(z_mm));
  }
  return levels;
}

ChosenLevel neckOrMiddle(const std::vector<BodyLevel>& levels) {
  constexpr double kNarrower = 0.75;
  const int count = static_cast<int>(levels.size());
  std::vector<double> below(levels.size()), above(levels.size());
  for (int n = 1; n < count; ++n) below[n] = std::max(below[n - 1], levels[n - 1].area_mm2);
  for (int n = count - 2; n >= 0; --n) above[n] = std::max(above[n + 1], levels[n + 1].area_mm2);
  ChosenLevel chosen{levels[count / 2], false};
  double narrowest = kNarrower;
  for (int n = count / 10; n < count - count / 10; ++n) {
    const double wider_mm2 = std::min(below[n], above[n]);
    if (levels[n].area_mm2 <= 0 || levels[n].area_mm2 >= narrowest * wider_mm2) continue;
    narrowest = levels[n].area_mm2 / wider_mm2;
    chosen = {levels[n], true};
  }
  return chosen;
}

}  // namespace insonate
