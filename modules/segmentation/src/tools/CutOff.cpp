#include <insonate/segmentation/CutOff.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <unordered_map>

namespace insonate {
namespace {

constexpr double kMaxDepth_mm = 20, kDepthStep_mm = 1;
/// A stroke that grazes the edge of a label separates single voxels of its staircase, which are no part of their own.
constexpr std::size_t kMinPart = 5;

struct Point2 {
  double x, y;
};

double cross2(Point2 a, Point2 b) {
  return a.x * b.y - a.y * b.x;
}

/// A stroke in the plane perpendicular to its direction of extension.
class Cut {
 public:
  explicit Cut(const CutStroke& stroke)
      : along_(normalized(stroke.along)),
        right_(normalized(cross(along_, std::abs(along_.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}))),
        down_(cross(along_, right_)),
        height_mm_(dot(stroke.points_mm.front(), along_)) {
    for (const Vec3& point_mm : stroke.points_mm) line_.push_back(flat(point_mm));
  }

  struct Crossing {
    double depth_mm;   ///< distance from the slice of the stroke
    bool fromTheLeft;  ///< the first voxel is on the left side of the stroke
  };
  /// Returns where the way between two neighboring voxels crosses the extended stroke.
  std::optional<Crossing> crossing(Vec3 from_mm, Vec3 to_mm) const;

 private:
  Point2 flat(Vec3 patient_mm) const { return {dot(patient_mm, right_), dot(patient_mm, down_)}; }

  Vec3 along_, right_, down_;
  double height_mm_;
  std::vector<Point2> line_;
};

std::optional<Cut::Crossing> Cut::crossing(Vec3 from_mm, Vec3 to_mm) const {
  const Point2 a = flat(from_mm), b = flat(to_mm), way{b.x - a.x, b.y - a.y};
  for (std::size_t n = 1; n < line_.size(); ++n) {
    const Point2 p = line_[n - 1], piece{line_[n].x - p.x, line_[n].y - p.y};
    const double from = cross2(piece, {a.x - p.x, a.y - p.y}), to = cross2(piece, {b.x - p.x, b.y - p.y});
    // A voxel on the stroke belongs to the left side.
    if ((from >= 0) == (to >= 0)) continue;
    const double part = from / (from - to);
    const Point2 at{a.x + way.x * part - p.x, a.y + way.y * part - p.y};
    const double length2 = piece.x * piece.x + piece.y * piece.y;
    // Neighboring pieces overlap a little, so that nothing passes between them.
    constexpr double kOverlap = 1e-9;
    const double place = (at.x * piece.x + at.y * piece.y) / length2;
    if (place < -kOverlap || place > 1 + kOverlap) continue;
    const Vec3 at_mm = from_mm + (to_mm - from_mm) * part;
    return Crossing{std::abs(dot(at_mm, along_) - height_mm_), from >= 0};
  }
  return std::nullopt;
}

/// Floods both sides of a cut in turn, one voxel of each side at a time, so that the time depends on the smaller side.
class CutFlood {
 public:
  CutFlood(const LabelMap& labels, std::uint8_t label, const CutStroke& stroke);
  bool crosses() const { return !pairs_.empty(); }
  /// Returns the voxels of the smaller side; no value if the sides are connected, or when cancelled.
  std::optional<std::vector<std::size_t>> smallerSide(double depth_mm);

 private:
  /// Two neighboring voxels on different sides of the stroke.
  struct Pair {
    std::size_t left, right;
    double depth_mm;
  };
  struct Side {
    std::vector<std::size_t> found;
    std::size_t next = 0;
  };
  bool add(std::size_t voxel, int side);
  bool step(int side, double depth_mm);

  const LabelMap& labels_;
  std::uint8_t label_;
  std::vector<Pair> pairs_;
  /// Depth of the cut between a voxel and its next neighbor on an axis; the key is 3 * offset + axis.
  std::unordered_map<std::size_t, double> cuts_;
  std::array<Side, 2> sides_;
  std::unordered_map<std::size_t, int> owner_;
};

CutFlood::CutFlood(const LabelMap& labels, std::uint8_t label, const CutStroke& stroke)
    : labels_(labels), label_(label) {
  const Cut cut(stroke);
  const VolumeGeometry& g = labels.geometry;
  const Transform patientFromIndex = g.patientFromIndex();
  const double around_mm = kMaxDepth_mm + norm(g.spacing_mm);
  const VoxelBox box = boxAround(g, stroke.points_mm, around_mm);
  for (int k = box.first[2]; k < box.end[2]; ++k)
    for (int j = box.first[1]; j < box.end[1]; ++j)
      for (int i = box.first[0]; i < box.end[0]; ++i) {
        if (labels.at(i, j, k) != label) continue;
        const Vec3 from_mm = patientFromIndex * Vec3{double(i), double(j), double(k)};
        for (int axis = 0; axis < 3; ++axis) {
          const std::array<int, 3> to{i + (axis == 0), j + (axis == 1), k + (axis == 2)};
          if (!g.contains(to[0], to[1], to[2]) || labels.at(to[0], to[1], to[2]) != label) continue;
          const auto found = cut.crossing(from_mm, from_mm + patientFromIndex.linear.column[std::size_t(axis)]);
          if (!found || found->depth_mm > kMaxDepth_mm) continue;
          const std::size_t from = g.offset(i, j, k), next = g.offset(to[0], to[1], to[2]);
          pairs_.push_back(found->fromTheLeft ? Pair{from, next, found->depth_mm} : Pair{next, from, found->depth_mm});
          cuts_.emplace(3 * from + std::size_t(axis), found->depth_mm);
        }
      }
}

/// Returns false if the voxel belongs to the other side.
bool CutFlood::add(std::size_t voxel, int side) {
  const auto [entry, isNew] = owner_.emplace(voxel, side);
  if (isNew) sides_[std::size_t(side)].found.push_back(voxel);
  return entry->second == side;
}

/// Adds the neighbors of the next voxel of a side; returns false if one of them belongs to the other side.
bool CutFlood::step(int side, double depth_mm) {
  Side& mine = sides_[std::size_t(side)];
  const std::size_t voxel = mine.found[mine.next++];
  const auto& size = labels_.geometry.size;
  const std::array<std::size_t, 3> stride{1, std::size_t(size[0]), std::size_t(size[0]) * std::size_t(size[1])};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto place = static_cast<int>(voxel / stride[axis] % std::size_t(size[axis]));
    for (const bool isOn : {false, true}) {
      if (isOn ? place + 1 >= size[axis] : place == 0) continue;
      const std::size_t lower = isOn ? voxel : voxel - stride[axis];
      const std::size_t other = isOn ? voxel + stride[axis] : lower;
      if (labels_.voxels[other] != label_) continue;
      const auto cut = cuts_.find(3 * lower + axis);
      if (cut != cuts_.end() && cut->second <= depth_mm) continue;
      if (!add(other, side)) return false;
    }
  }
  return true;
}

std::optional<std::vector<std::size_t>> CutFlood::smallerSide(double depth_mm) {
  sides_ = {};
  owner_.clear();
  for (const Pair& pair : pairs_) {
    if (pair.depth_mm > depth_mm) continue;
    if (!add(pair.left, 0) || !add(pair.right, 1)) return std::nullopt;
  }
  if (sides_[0].found.empty()) return std::nullopt;
  for (;;)
    for (const int side : {0, 1}) {
      Side& mine = sides_[std::size_t(side)];
      if (mine.next == mine.found.size()) return std::move(mine.found);
      if (!step(side, depth_mm)) return std::nullopt;
    }
}

Selection selected(const VolumeGeometry& g, const std::vector<std::size_t>& voxels) {
  VoxelBox box;
  const auto indexOf = [&g](std::size_t voxel) {
    const auto row = std::size_t(g.size[0]), slice = row * std::size_t(g.size[1]);
    return std::array{int(voxel % row), int(voxel % slice / row), int(voxel / slice)};
  };
  for (const std::size_t voxel : voxels) {
    const auto at = indexOf(voxel);
    box = united(box, {at, {at[0] + 1, at[1] + 1, at[2] + 1}});
  }
  Selection chosen(g, box);
  for (const std::size_t voxel : voxels) {
    const auto at = indexOf(voxel);
    chosen.mask.at(at[0] - box.first[0], at[1] - box.first[1], at[2] - box.first[2]) = 1;
  }
  return chosen;
}

}  // namespace

Result<Selection> partCutOff(const LabelMap& labels, std::uint8_t label, const CutStroke& stroke,
                             const Progress& progress) {
  double length_mm = 0;
  CutStroke cleaned{{}, stroke.along};
  for (const Vec3& point_mm : stroke.points_mm) {
    if (!cleaned.points_mm.empty() && norm(point_mm - cleaned.points_mm.back()) < 1e-3) continue;
    if (!cleaned.points_mm.empty()) length_mm += norm(point_mm - cleaned.points_mm.back());
    cleaned.points_mm.push_back(point_mm);
  }
  if (!(length_mm > 0)) return fail("A cut needs a stroke of two or more different points.");
  CutFlood flood(labels, label, cleaned);
  if (!flood.crosses())
    return fail("The stroke does not cross the label. Draw it across the neck of the part that you want to remove.");
  for (double depth_mm = kDepthStep_mm; depth_mm <= kMaxDepth_mm; depth_mm += kDepthStep_mm) {
    if (!report(progress, "Cutting", depth_mm / kMaxDepth_mm)) return fail(std::string(kCancelled));
    const auto voxels = flood.smallerSide(depth_mm);
    if (!voxels) continue;
    if (voxels->size() >= kMinPart) return selected(labels.geometry, *voxels);
    return fail(
        "The stroke only grazes the label: fewer than 5 voxels lie behind it. Draw it across the whole neck of the "
        "part "
        "that you want to remove, or erase single voxels with Erase.");
  }
  return fail(
      "The stroke does not cut the label apart: both sides are still connected. Draw it from one side of the neck to "
      "the other, beyond the edges of the label.");
}

}  // namespace insonate
