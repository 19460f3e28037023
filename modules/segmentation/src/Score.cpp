#include "Guarded.h"
#include "Work.h"

#include <insonate/segmentation/LabelEdit.h>
#include <insonate/segmentation/Score.h>
#include <insonate/tissue/Labels.h>

#include <nanoflann.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace insonate {
namespace {

using segmentation::Work;

/// Centers of a shape's outermost voxels, in mm along the axes of the grid.
class Surface {
 public:
  explicit Surface(const Selection& shape) {
    const VolumeGeometry& g = shape.mask.geometry;
    const auto outside = [&](int i, int j, int k) { return !g.contains(i, j, k) || !shape.mask.at(i, j, k); };
    for (int k = 0; k < g.size[2]; ++k)
      for (int j = 0; j < g.size[1]; ++j)
        for (int i = 0; i < g.size[0]; ++i)
          if (shape.mask.at(i, j, k) && (outside(i - 1, j, k) || outside(i + 1, j, k) || outside(i, j - 1, k) ||
                                         outside(i, j + 1, k) || outside(i, j, k - 1) || outside(i, j, k + 1)))
            points_.push_back({i * g.spacing_mm.x, j * g.spacing_mm.y, k * g.spacing_mm.z});
    tree_.buildIndex();
  }
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;

  double distanceTo_mm(const std::array<double, 3>& point) const {
    std::size_t nearest = 0;
    double square_mm2 = 0;
    tree_.knnSearch(point.data(), 1, &nearest, &square_mm2);
    return std::sqrt(square_mm2);
  }
  const std::vector<std::array<double, 3>>& points() const { return points_; }

  // The interface that nanoflann expects of a set of points.
  std::size_t kdtree_get_point_count() const { return points_.size(); }
  double kdtree_get_pt(std::size_t n, std::size_t axis) const { return points_[n][axis]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }

 private:
  using Tree =
      nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Surface>, Surface, 3, std::size_t>;

  std::vector<std::array<double, 3>> points_;
  Tree tree_{3, *this, nanoflann::KDTreeSingleIndexAdaptorParams(10)};
};

void measureSurfaces(LabelScore& score, const Selection& found, const Selection& truth, const Progress& progress) {
  const Surface a(found), b(truth);
  std::vector<double> distances_mm(a.points().size() + b.points().size());
  Work work(progress, 2);
  work.start("Measuring distances");
  constexpr int kPart = 1000;
  const auto measure = [&](const Surface& from, const Surface& to, std::size_t first) {
    const std::size_t count = from.points().size();
    work.slices(static_cast<int>(count / kPart) + 1, [&](int part) {
      const std::size_t begin = std::size_t(part) * kPart, end = std::min(count, begin + kPart);
      for (std::size_t n = begin; n < end; ++n) distances_mm[first + n] = to.distanceTo_mm(from.points()[n]);
    });
  };
  measure(a, b, 0);
  measure(b, a, a.points().size());
  std::ranges::sort(distances_mm);
  score.meanSurface_mm = std::accumulate(distances_mm.begin(), distances_mm.end(), 0.0) / double(distances_mm.size());
  score.p95Surface_mm = distances_mm[std::size_t(0.95 * double(distances_mm.size() - 1))];
}

LabelScore computeScore(const LabelMap& found, const LabelMap& truth, std::uint8_t label, const Progress& progress) {
  LabelScore score;
  score.label = label;
  std::size_t both = 0;
  for (std::size_t v = 0; v < truth.voxels.size(); ++v) {
    const bool here = found.voxels[v] == label, there = truth.voxels[v] == label;
    score.voxels += here, score.trueVoxels += there, both += here && there;
  }
  const std::size_t sum = score.voxels + score.trueVoxels;
  score.dice = sum > 0 ? 2.0 * double(both) / double(sum) : 1;
  if (score.voxels == 0 || score.trueVoxels == 0) return score;
  // A margin of one voxel, so that the surface of a shape that fills its box has an outside.
  const Vec3& s = truth.geometry.spacing_mm;
  const VoxelBox box = grown(united(boundingBoxOf(found, label), boundingBoxOf(truth, label)), truth.geometry,
                             std::min({s.x, s.y, s.z}));
  measureSurfaces(score, voxelsOf(found, label, box), voxelsOf(truth, label, box), progress);
  return score;
}

}  // namespace

Result<std::vector<LabelScore>> scoreLabels(const LabelMap& found, const LabelMap& truth,
                                            const std::vector<std::uint8_t>& labels, const Progress& progress) {
  if (!sameGrid(found.geometry, truth.geometry))
    return fail("The reference labels are on another grid than the case. Resample them to the grid of the case.");
  LabelSet asked;
  for (const std::uint8_t label : labels) asked.set(label);
  if (labels.empty()) {
    for (const std::uint8_t label : found.voxels) asked.set(label);
    for (const std::uint8_t label : truth.voxels) asked.set(label);
    asked.reset(kBackground);
  }
  return segmentation::guarded([&] {
    std::vector<LabelScore> scores;
    for (std::size_t label = asked._Find_first(); label < asked.size(); label = asked._Find_next(label)) {
      const auto done = double(scores.size());
      const Progress part = [&](std::string_view doing, double fraction) {
        return report(progress, doing, (done + fraction) / double(asked.count()));
      };
      scores.push_back(computeScore(found, truth, static_cast<std::uint8_t>(label), part));
    }
    return scores;
  });
}

}  // namespace insonate
