#include "SegmentationParts.h"

#include <insonate/cases/Phantom.h>
#include <insonate/segmentation/AutoLabel.h>
#include <insonate/segmentation/CentreLine.h>
#include <insonate/segmentation/Score.h>
#include <insonate/segmentation/VesselTracking.h>
#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <functional>
#include <span>

namespace insonate::bench {
namespace {

constexpr std::size_t kVesselsEach = 2;  // of a kind, the largest
constexpr double kShortest_mm = 40;

/// A vessel of the truth: its middle, and its voxels.
struct TrueVessel {
  CentreLine line;
  std::vector<std::array<int, 3>> voxels;
};

/// Voxels go to the line that is nearest, vessels come by falling volume.
std::vector<TrueVessel> vesselsOf(const LabelMap& labels, std::uint8_t label, std::vector<CentreLine> lines) {
  std::vector<TrueVessel> vessels;
  for (CentreLine& line : lines) vessels.push_back({std::move(line), {}});
  const Transform patientFromIndex = labels.geometry.patientFromIndex();
  const auto& [ni, nj, nk] = labels.geometry.size;
  for (int k = 0; k < nk; ++k)
    for (int j = 0; j < nj; ++j)
      for (int i = 0; i < ni; ++i) {
        if (labels.at(i, j, k) != label) continue;
        const Vec3 p = patientFromIndex * Vec3{double(i), double(j), double(k)};
        const auto nearest = std::ranges::min_element(
            vessels, {}, [&](const TrueVessel& vessel) { return *distanceToCentre_mm(std::span(&vessel.line, 1), p); });
        if (nearest != vessels.end()) nearest->voxels.push_back({i, j, k});
      }
  std::erase_if(vessels, [](const TrueVessel& v) { return double(v.line.size()) < kShortest_mm; });
  std::ranges::stable_sort(vessels, std::greater<>(), [](const TrueVessel& v) { return v.voxels.size(); });
  vessels.resize(std::min(vessels.size(), kVesselsEach));
  return vessels;
}

/// Between the planes square to a line at its ends.
bool isBetweenEnds(const CentreLine& line, Vec3 p) {
  const std::size_t inward = std::min<std::size_t>(4, line.size() - 1);
  return dot(p - line.front(), line[inward] - line.front()) >= 0 &&
         dot(p - line.back(), line[line.size() - 1 - inward] - line.back()) >= 0;
}

double diceOf(const TrackedVessel& found, const TrueVessel& truth, const VolumeGeometry& g) {
  const Transform patientFromIndex = g.patientFromIndex();
  const auto counts = [&](int i, int j, int k) {
    return isBetweenEnds(truth.line, patientFromIndex * Vec3{double(i), double(j), double(k)});
  };
  std::size_t both = 0, voxels = 0, trueVoxels = 0;
  for (const auto& [i, j, k] : truth.voxels)
    if (counts(i, j, k)) ++trueVoxels, both += found.lumen.chosen(i, j, k);
  const VoxelBox& box = found.lumen.box;
  for (int k = box.first[2]; k < box.end[2]; ++k)
    for (int j = box.first[1]; j < box.end[1]; ++j)
      for (int i = box.first[0]; i < box.end[0]; ++i) voxels += found.lumen.chosen(i, j, k) && counts(i, j, k);
  return voxels + trueVoxels > 0 ? 2.0 * double(both) / double(voxels + trueVoxels) : 0;
}

Result<void> scoreVessels(const PatientCase& patient, std::uint8_t label, const SegmentationScoreRow& about,
                          std::vector<SegmentationScoreRow>& rows, const Progress& progress) {
  auto lines = centreLines(patient.labels, label, progress);
  if (!lines) return tl::unexpected(lines.error());
  int number = 0;
  for (const TrueVessel& vessel : vesselsOf(patient.labels, label, std::move(*lines))) {
    ++number;
    for (const int clicks : {2, 4}) {
      std::vector<Vec3> clicks_mm;
      for (int n = 0; n < clicks; ++n)
        clicks_mm.push_back(vessel.line[(vessel.line.size() - 1) * std::size_t(n) / std::size_t(clicks - 1)]);
      const auto tracked = trackVessel(patient.ct, clicks_mm, {}, progress);
      if (!tracked && tracked.error().message == kCancelled) return tl::unexpected(tracked.error());
      SegmentationScoreRow row = about;
      row.structure = labelName(label) + " " + std::to_string(number);
      row.clicks = clicks;
      row.dice = tracked ? diceOf(*tracked, vessel, patient.ct.geometry) : 0;
      rows.push_back(row);
    }
  }
  return {};
}

}  // namespace

Result<std::vector<SegmentationScoreRow>> scoreNeck(const NeckScan& scan, const Progress& progress) {
  auto patient = makePhantom(scan.variant, 1, progress, scan.contrast);
  if (!patient) return tl::unexpected(patient.error());
  auto ct = synthesiseCt(patient->labels, {.seed = 1, .contrast = scan.contrast, .noise_HU = scan.noise_HU}, progress);
  if (!ct) return tl::unexpected(ct.error());
  patient->ct = std::move(*ct);
  const auto labels = autoLabel(patient->ct, progress);
  if (!labels) return tl::unexpected(labels.error());
  const auto scores = scoreLabels(*labels, patient->labels, {kBone, kAirway, kSkin, kFat, kMuscle}, progress);
  if (!scores) return tl::unexpected(scores.error());

  SegmentationScoreRow about;
  about.variant = scan.variant;
  about.contrast = scan.contrast == CtContrast::kNative ? "native" : "arterial";
  about.noise_HU = scan.noise_HU;
  std::vector<SegmentationScoreRow> rows;
  for (const LabelScore& score : *scores) {
    SegmentationScoreRow row = about;
    row.structure = labelName(score.label);
    row.dice = score.dice, row.meanSurface_mm = score.meanSurface_mm, row.p95Surface_mm = score.p95Surface_mm;
    rows.push_back(row);
  }
  if (scan.contrast == CtContrast::kNative) return rows;
  for (const Label label : {kVein, kArtery})
    if (auto ok = scoreVessels(*patient, label, about, rows, progress); !ok) return tl::unexpected(ok.error());
  return rows;
}

}  // namespace insonate::bench
