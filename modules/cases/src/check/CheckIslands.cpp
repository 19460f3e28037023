#include "Checks.h"
#include "Islands.h"

#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace insonate::check {
namespace {

std::string inMillilitres(double mm3) {
  return mm3 < 1000 ? std::to_string(std::lround(mm3)) + " mm3" : std::to_string(std::lround(mm3 / 1000)) + " ml";
}

/// Finds labels apart from the body: a table, a tube, or a leak of a tool into the air.
void checkApart(const CaseView& patient, Findings& findings) {
  constexpr double kApart_mm3 = 20;
  std::vector<Island> bodies = islandsOf(patient.labels, Joining::kAnyLabel);
  if (bodies.size() < 2) return;
  std::ranges::sort(bodies, std::greater{}, &Island::voxels);
  std::size_t apart = 0;
  for (std::size_t n = 1; n < bodies.size(); ++n) apart += bodies[n].voxels;
  const double apart_mm3 = double(apart) * voxelVolume_mm3(patient.labels.geometry);
  if (apart_mm3 < kApart_mm3) return;
  const Island& first = bodies[1];
  findings.push_back({FindingSeverity::kWarning, "label_outside",
                      inMillilitres(apart_mm3) + " of labels lie outside the body, most of it " +
                          labelName(first.label) + " at " + placeText(placeOf(patient.labels.geometry, first.first)) +
                          ". Erase voxels that do not belong to the patient.",
                      placeOf(patient.labels.geometry, first.first), first.label});
}

/// Organs are connected. Tissue between them (fat, muscle, soft tissue), nerves and nodes need not be. Vessels have a
/// finding of their own.
bool isCompact(std::uint8_t label) {
  constexpr std::array kCompact{kBone, kCartilage, kAirway, kThyroid, kSternocleidomastoid, kOesophagus, kGland};
  return std::ranges::find(kCompact, label) != kCompact.end();
}

/// Small islands that a threshold leaves.
void checkCrumbs(const CaseView& patient, Findings& findings) {
  constexpr double kCrumb_mm3 = 5;
  constexpr int kMany = 50;
  struct Crumbs {
    int count = 0;
    std::size_t first = 0;
  };
  std::array<Crumbs, 256> crumbs;
  const double voxel_mm3 = voxelVolume_mm3(patient.labels.geometry);
  for (const Island& island : islandsOf(patient.labels, Joining::kOneLabel)) {
    if (!isCompact(island.label) || double(island.voxels) * voxel_mm3 >= kCrumb_mm3) continue;
    Crumbs& of = crumbs[island.label];
    if (of.count++ == 0) of.first = island.first;
  }
  const auto most = std::ranges::max_element(crumbs, {}, &Crumbs::count);
  int all = 0;
  for (const Crumbs& one : crumbs) all += one.count;
  if (all < kMany) return;
  const auto label = static_cast<std::uint8_t>(most - crumbs.begin());
  findings.push_back({FindingSeverity::kInfo, "islands",
                      "The labels have " + std::to_string(all) + " islands of less than " +
                          std::to_string(int(kCrumb_mm3)) + " mm3, most of them (" + std::to_string(most->count) +
                          ") in " + labelName(label) + "; they look like grains in the image. Remove small islands.",
                      placeOf(patient.labels.geometry, most->first), label});
}

}  // namespace

void checkIslands(const CaseView& patient, Findings& findings) {
  checkApart(patient, findings);
  checkCrumbs(patient, findings);
}

}  // namespace insonate::check
