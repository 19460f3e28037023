#include "Guarded.h"
#include "ItkRun.h"

#include <insonate/segmentation/LabelEdit.h>
#include <insonate/segmentation/Score.h>
#include <insonate/tissue/Labels.h>

#include <itkSignedMaurerDistanceMapImageFilter.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace insonate {
namespace {

/// The voxels of a selection that have a face outside it.
std::vector<std::size_t> surfaceOf(const Selection& shape) {
  std::vector<std::size_t> surface;
  const auto [ni, nj, nk] = shape.mask.geometry.size;
  const auto outside = [&](int i, int j, int k) {
    return !shape.mask.geometry.contains(i, j, k) || !shape.mask.at(i, j, k);
  };
  for (int k = 0; k < nk; ++k)
    for (int j = 0; j < nj; ++j)
      for (int i = 0; i < ni; ++i)
        if (shape.mask.at(i, j, k) && (outside(i - 1, j, k) || outside(i + 1, j, k) || outside(i, j - 1, k) ||
                                       outside(i, j + 1, k) || outside(i, j, k - 1) || outside(i, j, k + 1)))
          surface.push_back(shape.mask.geometry.offset(i, j, k));
  return surface;
}

/// Of each voxel of the box to the surface of a shape, mm.
itk::Image<float, 3>::Pointer distancesTo(Selection& shape, const Progress& progress) {
  auto maurer = itk::SignedMaurerDistanceMapImageFilter<itk::Image<std::uint8_t, 3>, itk::Image<float, 3>>::New();
  maurer->SetInput(segmentation::itkImageOver(shape.mask));
  maurer->SetUseImageSpacing(true);
  maurer->SetSquaredDistance(false);
  segmentation::run(*maurer, progress, "Measuring distances");
  return maurer->GetOutput();
}

void measureSurfaces(LabelScore& score, Selection found, Selection truth, const Progress& progress) {
  std::vector<double> distances_mm;
  const auto collect = [&](Selection& from, Selection& to) {
    const auto image = distancesTo(to, progress);
    for (const std::size_t v : surfaceOf(from)) distances_mm.push_back(std::abs(image->GetBufferPointer()[v]));
  };
  collect(found, truth);
  collect(truth, found);
  std::ranges::sort(distances_mm);
  score.meanSurface_mm = std::accumulate(distances_mm.begin(), distances_mm.end(), 0.0) / double(distances_mm.size());
  score.p95Surface_mm = distances_mm[std::size_t(0.95 * double(distances_mm.size() - 1))];
}

LabelScore scoreOf(const LabelMap& found, const LabelMap& truth, std::uint8_t label, const Progress& progress) {
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
  // A voxel around, so that the surface of a shape that fills its box has an outside.
  const Vec3& s = truth.geometry.spacing_mm;
  const VoxelBox box =
      grown(united(extentOf(found, label), extentOf(truth, label)), truth.geometry, std::min({s.x, s.y, s.z}));
  measureSurfaces(score, voxelsOf(found, label, box), voxelsOf(truth, label, box), progress);
  return score;
}

}  // namespace

Result<std::vector<LabelScore>> scoreLabels(const LabelMap& found, const LabelMap& truth,
                                            const std::vector<std::uint8_t>& labels, const Progress& progress) {
  if (!sameGrid(found.geometry, truth.geometry))
    return fail("The truth is on another grid than the labels; resample it to that of the case.");
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
      scores.push_back(scoreOf(found, truth, static_cast<std::uint8_t>(label), part));
    }
    return scores;
  });
}

}  // namespace insonate
