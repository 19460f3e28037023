#include "SegmentationParts.h"

#include <insonate/cases/Phantom.h>
#include <insonate/segmentation/AutoLabel.h>
#include <insonate/segmentation/Brush.h>
#include <insonate/segmentation/GrowFromSeeds.h>
#include <insonate/segmentation/LabelEdit.h>
#include <insonate/segmentation/LevelSet.h>
#include <insonate/segmentation/RegionGrowing.h>
#include <insonate/segmentation/Threshold.h>
#include <insonate/tissue/Labels.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <functional>

namespace insonate::bench {
namespace {

constexpr double kRegion_mm = 30;  // from a click to the edge of the region of growing and level set

/// The textbook neck with contrast, on a grid of this size over the same part of the patient.
Result<PatientCase> largeNeck(const std::array<int, 3>& size, const Progress& progress) {
  auto patient = makePhantom("textbook", 1, progress, CtContrast::kArterial);
  if (!patient) return tl::unexpected(patient.error());
  const CtVolume small = std::move(patient->ct);
  VolumeGeometry g = small.geometry;
  for (int axis = 0; axis < 3; ++axis) {
    g.spacing_mm[axis] *= double(g.size[axis]) / size[axis];
    g.size[axis] = size[axis];
  }
  patient->ct = CtVolume(g);
  patient->labels = LabelMap(g, kSoftTissue);
  const Transform smallFromLarge = small.geometry.indexFromPatient() * g.patientFromIndex();
  tbb::parallel_for(0, size[2], [&](int k) {
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i)
        patient->ct.at(i, j, k) =
            static_cast<std::int16_t>(sampleLinear(small, smallFromLarge * Vec3{double(i), double(j), double(k)}));
  });
  return patient;
}

SegmentationTimeRow timed(const std::string& task, double voxels, int repeats, const std::function<void()>& work) {
  std::vector<double> ms;
  for (int n = 0; n < repeats; ++n) {
    const auto start = std::chrono::steady_clock::now();
    work();
    ms.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  std::ranges::sort(ms);
  return {task, voxels, ms[ms.size() / 2], ms.back()};
}

double voxelsIn(const VoxelBox& box) {
  return double(box.length(0)) * box.length(1) * box.length(2);
}

}  // namespace

Result<std::vector<SegmentationTimeRow>> timeTools(const std::array<int, 3>& size, const Progress& progress) {
  auto patient = largeNeck(size, progress);
  if (!patient) return tl::unexpected(patient.error());
  const CtVolume& ct = patient->ct;
  const auto all = double(ct.voxels.size());
  const Vec3 vein_mm = patient->manifest.targets.front().position_mm;
  const VoxelBox region = boxAround(ct.geometry, std::array{vein_mm}, kRegion_mm);
  std::vector<SegmentationTimeRow> rows;

  LabelEdit edit(ct, patient->labels);
  int dab = 0;
  rows.push_back(timed("brush stroke with a sphere of 5 mm radius", all, 50, [&] {
    const std::array stroke{vein_mm + Vec3{0.5 * dab, 0, 0}, vein_mm + Vec3{0.5 * dab + 4, 0, 0}};
    ++dab;
    static_cast<void>(edit.apply(painted(brushed(ct.geometry, stroke, {.radius_mm = 5}), kVein), "paint"));
  }));
  Selection preview(ct.geometry, boxOf(ct.geometry));
  rows.push_back(timed("threshold preview on whole CT", all, 9, [&] { threshold(ct, {150, 3000}, preview); }));
  rows.push_back(timed("threshold written on whole CT", all, 1,
                       [&] { static_cast<void>(edit.apply(painted(std::move(preview), kBone), "threshold")); }));
  rows.push_back(timed("undo of it", all, 1, [&] { edit.undo(); }));
  rows.push_back(timed("connected growing on region", voxelsIn(region), 3, [&] {
    static_cast<void>(connected(ct, region, std::array{vein_mm}, {120, 240}, progress));
  }));
  const Selection start = [&] {
    Selection chosen(ct.geometry, region);
    const Selection ball = brushed(ct.geometry, std::array{vein_mm}, {.radius_mm = 3});
    for (int k = ball.box.first[2]; k < ball.box.end[2]; ++k)
      for (int j = ball.box.first[1]; j < ball.box.end[1]; ++j)
        for (int i = ball.box.first[0]; i < ball.box.end[0]; ++i)
          chosen.mask.at(i - region.first[0], j - region.first[1], k - region.first[2]) = ball.chosen(i, j, k);
    return chosen;
  }();
  rows.push_back(timed("geodesic level set on region", voxelsIn(region), 1,
                       [&] { static_cast<void>(levelSet(ct, start, {}, progress)); }));
  Seeds seeds = seedsOf(patient->labels, region, LabelSet().set(kVein).set(kFat), LabelSet().set(kSoftTissue));
  seeds.painted.labels.voxels.front() = kFat;
  rows.push_back(timed("growing from seeds on region", voxelsIn(region), 1,
                       [&] { static_cast<void>(grownFromSeeds(ct, seeds, {}, progress)); }));
  Result<LabelMap> labels = fail("");
  rows.push_back(timed("automatic part on whole CT", all, 1, [&] { labels = autoLabel(ct, progress); }));
  if (!labels) return tl::unexpected(labels.error());
  return rows;
}

}  // namespace insonate::bench
