#include "NeckLevel.h"

#include <cmath>
#include <limits>

namespace insonate {
namespace {

constexpr double kPixel_mm = 3, kLevel_mm = 3, kAside_mm = 25;
constexpr double kNowhere_mm = 1e6;

struct Box {
  Vec3 low_mm, high_mm;
};

Box patientBoxOf(const VolumeGeometry& g) {
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

/// Finds connected parts of the body in one level, cell by cell.
class Slice {
 public:
  Slice(const PatientBody& body, const Box& box, double z_mm)
      : box_(box),
        columns_(static_cast<int>((box.high_mm.x - box.low_mm.x) / kPixel_mm) + 1),
        rows_(static_cast<int>((box.high_mm.y - box.low_mm.y) / kPixel_mm) + 1),
        inside_(static_cast<std::size_t>(columns_) * rows_) {
    for (int j = 0; j < rows_; ++j)
      for (int i = 0; i < columns_; ++i)
        inside_[cell(i, j)] = body.contains({x(i), box.low_mm.y + j * kPixel_mm, z_mm});
  }

  BodyLevel largest(double z_mm) {
    BodyLevel best{z_mm, 0, 0, kNowhere_mm};
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
  double x(int i) const { return box_.low_mm.x + i * kPixel_mm; }

  /// Returns the part around a cell and removes it from the level.
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
    return {z_mm, cells * kPixel_mm * kPixel_mm, sum_mm / cells, kNowhere_mm};
  }

  const Box& box_;
  int columns_, rows_;
  std::vector<std::uint8_t> inside_;
};

/// Half of the levels have their center on either side of the result: arms that are connected at some levels have no
/// effect.
double midlineOf(const std::vector<BodyLevel>& levels) {
  std::vector<double> middles_mm;
  for (const BodyLevel& level : levels)
    if (level.area_mm2 > 0) middles_mm.push_back(level.middle_mm);
  if (middles_mm.empty()) return 0;
  std::ranges::nth_element(middles_mm, middles_mm.begin() + static_cast<std::ptrdiff_t>(middles_mm.size() / 2));
  return middles_mm[middles_mm.size() / 2];
}

/// The first of four cells of body in a row; a blanket is thinner.
double pointInFrontOf(const PatientBody& body, const Box& box, double x_mm, double z_mm) {
  constexpr int kThick = 4;
  int thick = 0;
  for (double y_mm = box.low_mm.y; y_mm <= box.high_mm.y; y_mm += kPixel_mm) {
    thick = body.contains({x_mm, y_mm, z_mm}) ? thick + 1 : 0;
    if (thick == kThick) return y_mm - (kThick - 1) * kPixel_mm;
  }
  return kNowhere_mm;
}

/// Distance by which the front at level n lies behind the most anterior level below and the most anterior level above.
double hollow_mm(const std::vector<BodyLevel>& levels, int n) {
  const auto before = [](const BodyLevel& a, const BodyLevel& b) { return a.front_mm < b.front_mm; };
  const auto here = levels.begin() + n;
  const double below_mm = std::min_element(levels.begin(), here + 1, before)->front_mm;
  const double above_mm = std::min_element(here, levels.end(), before)->front_mm;
  return here->front_mm == kNowhere_mm ? 0 : here->front_mm - std::max(below_mm, above_mm);
}

/// The cross-section of a head is 150 to 300 cm2, that of a trunk twice as large.
bool hasHeadAbove(const std::vector<BodyLevel>& levels, int n) {
  constexpr double kReach_mm = 60, kMin_mm2 = 10000, kMax_mm2 = 35000;
  double largest_mm2 = 0;
  for (const BodyLevel& level : levels)
    if (level.z_mm > levels[n].z_mm + kReach_mm) largest_mm2 = std::max(largest_mm2, level.area_mm2);
  return largest_mm2 > kMin_mm2 && largest_mm2 < kMax_mm2;
}

}  // namespace

std::vector<BodyLevel> bodyLevels(const PatientBody& body, const VolumeGeometry& grid) {
  const Box box = patientBoxOf(grid);
  const double height_mm = box.high_mm.z - box.low_mm.z;
  const int count = static_cast<int>(height_mm / kLevel_mm) + 1;
  std::vector<BodyLevel> levels;
  for (int n = 0; n < count; ++n) {
    const double z_mm = box.low_mm.z + (n + 0.5) * height_mm / count;
    levels.push_back(Slice(body, box, z_mm).largest(z_mm));
  }
  const double midline_mm = midlineOf(levels);
  for (BodyLevel& level : levels) {
    level.middle_mm = midline_mm;
    level.front_mm = pointInFrontOf(body, box, midline_mm - kAside_mm, level.z_mm);
  }
  return levels;
}

ChosenLevel neckOrMiddle(const std::vector<BodyLevel>& levels) {
  // A thick neck has four fifths of the head's cross-section, but a fraction of that of the shoulders; a waist has no
  // shoulders.
  constexpr double kOfHead = 0.88, kOfShoulders = 0.6, kHollow_mm = 15;
  const int count = static_cast<int>(levels.size());
  ChosenLevel narrow{levels[count / 2], false}, hollow = narrow;
  double narrowest = kOfHead, deepest_mm = kHollow_mm;
  const auto area = [](const BodyLevel& a, const BodyLevel& b) { return a.area_mm2 < b.area_mm2; };
  for (int n = count / 10; n < count - count / 10; ++n) {
    const auto here = levels.begin() + n;
    const double below_mm2 = std::max_element(levels.begin(), here + 1, area)->area_mm2;
    const double above_mm2 = std::max_element(here, levels.end(), area)->area_mm2;
    if (here->area_mm2 > 0 && here->area_mm2 < narrowest * above_mm2 && here->area_mm2 < kOfShoulders * below_mm2) {
      narrowest = here->area_mm2 / above_mm2;
      narrow = {*here, true};
    }
    if (const double depth_mm = hollow_mm(levels, n); depth_mm > deepest_mm && hasHeadAbove(levels, n)) {
      deepest_mm = depth_mm;
      hollow = {*here, true};
    }
  }
  return hollow.isNeck ? hollow : narrow;
}

}  // namespace insonate
