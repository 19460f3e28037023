#include "SegmentationParts.h"
#include "TaskTimer.h"

#include <insonate/cases/Phantom.h>
#include <insonate/segmentation/AutoLabel.h>
#include <insonate/segmentation/Brush.h>
#include <insonate/segmentation/GrowFromSeeds.h>
#include <insonate/segmentation/LabelEdit.h>
#include <insonate/segmentation/LevelSet.h>
#include <insonate/segmentation/RegionGrowing.h>
#include <insonate/segmentation/Threshold.h>
#include <insonate/simulator/NeckAtlas.h>
#include <insonate/tissue/Labels.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <functional>

namespace insonate::bench {
namespace {

constexpr double kRegion_mm = 30;  // distance from a click to the edge of the region for growing and level set
constexpr double kFrame_ms = 33, kPreview_ms = 100, kRegion_ms = 3000, kAutomatic_ms = 60000,
                 kStructures_ms = 45000;  // targets

/// The textbook neck with contrast agent, on a grid of this size over the same region.
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

double voxelsIn(const VoxelBox& box) {
  return double(box.length(0)) * box.length(1) * box.length(2);
}

/// A ball in the vein, as a click selects it.
Selection ballIn(const VolumeGeometry& geometry, const VoxelBox& region, Vec3 center_mm) {
  Selection chosen(geometry, region);
  const Selection ball = strokeVoxels(geometry, std::array{center_mm}, {.radius_mm = 3});
  for (int k = ball.box.first[2]; k < ball.box.end[2]; ++k)
    for (int j = ball.box.first[1]; j < ball.box.end[1]; ++j)
      for (int i = ball.box.first[0]; i < ball.box.end[0]; ++i)
        chosen.mask.at(i - region.first[0], j - region.first[1], k - region.first[2]) = ball.isSelected(i, j, k);
  return chosen;
}

void timeWholeCt(PatientCase& patient, Vec3 vein_mm, TaskTimer& timer) {
  const CtVolume& ct = patient.ct;
  const auto all = double(ct.voxels.size());
  LabelEdit edit(ct, patient.labels);
  int dab = 0;
  timer.time({"brush stroke with a sphere of 5 mm radius", all, kFrame_ms}, 50, [&](const Progress&) {
    const std::array stroke{vein_mm + Vec3{0.5 * dab, 0, 0}, vein_mm + Vec3{0.5 * dab + 4, 0, 0}};
    ++dab;
    static_cast<void>(edit.apply(proposePainting(strokeVoxels(ct.geometry, stroke, {.radius_mm = 5}), kVein), "paint"));
  });
  Selection preview(ct.geometry, boxOf(ct.geometry));
  timer.time({"threshold preview on whole CT", all, kPreview_ms}, 9, [&](const Progress&) {
    threshold(ct, {150, 3000}, preview);
  });
  timer.time({"threshold written on whole CT", all, {}}, 1, [&](const Progress&) {
    static_cast<void>(edit.apply(proposePainting(std::move(preview), kBone), "threshold"));
  });
  timer.time({"undo of it", all, {}}, 1, [&](const Progress&) { edit.undo(); });
}

void timeRegion(const PatientCase& patient, Vec3 vein_mm, TaskTimer& timer) {
  const CtVolume& ct = patient.ct;
  const VoxelBox region = boxAround(ct.geometry, std::array{vein_mm}, kRegion_mm);
  timer.time({"connected growing on region", voxelsIn(region), kRegion_ms}, 3, [&](const Progress& progress) {
    static_cast<void>(connected(ct, region, std::array{vein_mm}, {120, 240}, progress));
  });
  const Selection start = ballIn(ct.geometry, region, vein_mm);
  timer.time({"geodesic level set on region", voxelsIn(region), kRegion_ms}, 3,
             [&](const Progress& progress) { static_cast<void>(levelSet(ct, start, {}, progress)); });
  const auto vein = connected(ct, region, std::array{vein_mm}, {120, 240});
  if (vein)
    timer.time({"geodesic level set from a whole vein", voxelsIn(region), kRegion_ms}, 3,
               [&](const Progress& progress) { static_cast<void>(levelSet(ct, *vein, {}, progress)); });
  Seeds seeds = seedsOf(patient.labels, region, LabelSet().set(kVein).set(kFat), LabelSet().set(kSoftTissue));
  seeds.painted.labels.voxels.front() = kFat;
  timer.time({"growing from seeds on region", voxelsIn(region), kRegion_ms}, 3,
             [&](const Progress& progress) { static_cast<void>(grownFromSeeds(ct, seeds, {}, progress)); });
}

}  // namespace

Result<void> timeTools(const std::array<int, 3>& size, SegmentationBench& bench, const Progress& progress) {
  auto patient = largeNeck(size, progress);
  if (!patient) return tl::unexpected(patient.error());
  const Vec3 vein_mm = patient->manifest.targets.front().position_mm;
  TaskTimer timer(bench, progress);
  timeWholeCt(*patient, vein_mm, timer);
  timeRegion(*patient, vein_mm, timer);
  const auto voxels = double(patient->ct.voxels.size());
  Result<LabelMap> labels = fail("");
  forgetPeakMemory();
  timer.time({"automatic part on whole CT", voxels, kAutomatic_ms}, 1,
             [&](const Progress& ofTask) { labels = autoLabel(patient->ct, ofTask); });
  if (!labels) return tl::unexpected(labels.error());
  const auto atlas = makeNeckAtlas(progress);
  if (!atlas) return tl::unexpected(atlas.error());
  timer.time({"vessels, thyroid and muscles on whole CT", voxels, kStructures_ms}, 1,
             [&](const Progress& ofTask) { static_cast<void>(proposeNeck(patient->ct, *labels, *atlas, ofTask)); });
  if (const auto peak = peakMemory_bytes()) bench.memory = {*peak * 1e-6, *peak / voxels};
  bench.notes.push_back(machineNote());
  return {};
}

}  // namespace insonate::bench
