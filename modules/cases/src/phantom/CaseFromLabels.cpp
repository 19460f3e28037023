#include "CompleteAnatomy.h"
#include "LabelPlan.h"

#include <insonate/cases/CaseFromLabels.h>
#include <insonate/cases/LabelFile.h>
#include <insonate/cases/PlaceProposal.h>
#include <insonate/cases/StartPose.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace insonate {
namespace {

using Numbers = Volume<std::int32_t>;

/// The part of a volume whose voxel centers lie in a box of patient space.
Result<Numbers> cropped(const Numbers& whole, const std::pair<Vec3, Vec3>& box_mm) {
  const Transform indexFromPatient = whole.geometry.indexFromPatient();
  Vec3 low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p{corner & 1 ? box_mm.first.x : box_mm.second.x, corner & 2 ? box_mm.first.y : box_mm.second.y,
                 corner & 4 ? box_mm.first.z : box_mm.second.z};
    const Vec3 index = indexFromPatient * p;
    for (int a = 0; a < 3; ++a) low[a] = std::min(low[a], index[a]), high[a] = std::max(high[a], index[a]);
  }
  std::array<int, 3> first{}, size{};
  for (int a = 0; a < 3; ++a) {
    const double from = std::max(0.0, std::ceil(low[a])),
                 to = std::min(whole.geometry.size[a] - 1.0, std::floor(high[a]));
    if (to < from) return fail("The crop box lies outside the label map.");
    first[a] = static_cast<int>(from);
    size[a] = static_cast<int>(to - from) + 1;
  }
  VolumeGeometry g = whole.geometry;
  g.origin_mm = g.patientFromIndex() * Vec3{double(first[0]), double(first[1]), double(first[2])};
  g.size = size;
  Numbers part(g);
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      std::copy_n(&whole.at(first[0], first[1] + j, first[2] + k), size[0], &part.at(0, j, k));
  return part;
}

Result<LabelMap> translated(const Numbers& numbers, const LabelPlan& plan) {
  LabelMap labels(numbers.geometry);
  std::map<std::int32_t, std::uint8_t> known(plan.labels.begin(), plan.labels.end());
  known.emplace(0, kBackground);
  for (std::size_t n = 0; n < numbers.voxels.size(); ++n) {
    const auto found = known.find(numbers.voxels[n]);
    if (found != known.end()) {
      labels.voxels[n] = found->second;
    } else if (plan.others) {
      labels.voxels[n] = *plan.others;
    } else {
      return fail("The label file holds the number " + std::to_string(numbers.voxels[n]) +
                  ", which \"labels\" does not list; list it or give \"others\".");
    }
  }
  return labels;
}

/// A table for another file would make a patient that contains only the filling tissue.
Result<void> checkMapFits(const Numbers& numbers, const LabelPlan& plan) {
  std::size_t labelled = 0, listed = 0, mapped = 0;
  for (const std::int32_t number : numbers.voxels) {
    if (number == 0) continue;
    ++labelled;
    const auto found = plan.labels.find(number);
    if (found == plan.labels.end()) continue;
    ++listed;
    mapped += found->second != kBackground;
  }
  if (labelled == 0)
    return fail("The label file contains only 0, so it has no structures. Check that it is the right file and region.");
  if (mapped == 0)
    return fail(
        "\"labels\" matches no structure in the label file: the file contains none of its numbers, or only as "
        "background. Check that the map belongs to this file.");
  if (2 * listed < labelled)
    return fail("\"labels\" lists the numbers of only " + std::to_string(100 * listed / labelled) +
                " % of the labeled voxels, but at least half is needed. Check that the map belongs to this file, or "
                "list more numbers.");
  return {};
}

/// Center of a number's voxels in the slice nearest to a level; empty if there are none.
std::optional<Vec3> centerOf(const Numbers& numbers, const TargetPlan& target) {
  const VolumeGeometry& g = numbers.geometry;
  const Transform patientFromIndex = g.patientFromIndex();
  const double k0 = (target.z_mm - g.origin_mm.z) / (patientFromIndex.linear.column[2].z);
  const int k = static_cast<int>(std::lround(k0));
  if (k < 0 || k >= g.size[2]) return std::nullopt;
  Vec3 sum;
  double count = 0;
  for (int j = 0; j < g.size[1]; ++j)
    for (int i = 0; i < g.size[0]; ++i)
      if (numbers.at(i, j, k) == target.number) sum = sum + Vec3{double(i), double(j), double(k)}, ++count;
  if (count == 0) return std::nullopt;
  return patientFromIndex * (sum / count);
}

/// Centers of a number's sections along the grid axis of its greatest length, with the radius of a circle of the
/// section's area; empty if it has no voxels.
std::vector<NamedVessel::Point> courseOf(const Numbers& numbers, std::int32_t number) {
  const VolumeGeometry& g = numbers.geometry;
  std::array<int, 3> first = g.size, last{-1, -1, -1}, p{};
  std::vector<std::array<int, 3>> voxels;
  for (p[2] = 0; p[2] < g.size[2]; ++p[2])
    for (p[1] = 0; p[1] < g.size[1]; ++p[1])
      for (p[0] = 0; p[0] < g.size[0]; ++p[0]) {
        if (numbers.at(p[0], p[1], p[2]) != number) continue;
        voxels.push_back(p);
        for (int a = 0; a < 3; ++a) first[a] = std::min(first[a], p[a]), last[a] = std::max(last[a], p[a]);
      }
  if (voxels.empty()) return {};
  int along = 0;
  for (int a = 1; a < 3; ++a)
    if ((last[a] - first[a]) * g.spacing_mm[a] > (last[along] - first[along]) * g.spacing_mm[along]) along = a;
  struct Section {
    Vec3 sum;
    double count = 0;
  };
  std::vector<Section> sections(static_cast<std::size_t>(last[along] - first[along] + 1));
  for (const auto& voxel : voxels) {
    Section& section = sections[static_cast<std::size_t>(voxel[along] - first[along])];
    section.sum = section.sum + Vec3{double(voxel[0]), double(voxel[1]), double(voxel[2])}, ++section.count;
  }
  const double area_mm2 = g.spacing_mm[(along + 1) % 3] * g.spacing_mm[(along + 2) % 3];
  std::vector<NamedVessel::Point> course;
  for (const Section& section : sections)
    if (section.count > 0)
      course.push_back({g.patientFromIndex() * (section.sum / section.count),
                        std::sqrt(section.count * area_mm2 / std::numbers::pi)});
  return course;
}

/// A transverse pose over each target, and the same pose turned along the body with the marker toward the feet.
void addStartPoses(PatientCase& patient, std::vector<std::string>& notes) {
  for (const Target& target : patient.manifest.targets) {
    const auto pose = proposeStartPoseOver(patient, target);
    if (!pose) {
      notes.push_back("No start pose over the " + target.name + ": " + pose.error().message);
      continue;
    }
    StartPose transverse = *pose, longitudinal = longitudinalPose(*pose, {0, 0, 1});
    transverse.name = target.name + ", transverse";
    longitudinal.name = target.name + ", longitudinal";
    patient.manifest.startPoses.push_back(transverse);
    patient.manifest.startPoses.push_back(longitudinal);
  }
}

}  // namespace

Result<CaseFromLabelsResult> caseFromLabels(const std::filesystem::path& labelFile,
                                            const std::filesystem::path& mapFile, const CtSynthesisOptions& ct,
                                            const Progress& progress) {
  auto plan = readLabelPlan(mapFile);
  if (!plan) return tl::unexpected(plan.error());
  auto numbers = readLabelValues(labelFile);
  if (!numbers) return tl::unexpected(numbers.error());
  if (plan->crop_mm) {
    auto part = cropped(*numbers, *plan->crop_mm);
    if (!part) return tl::unexpected(part.error());
    numbers = std::move(part);
  }
  auto labels = translated(*numbers, *plan);
  if (!labels) return tl::unexpected(labels.error());
  if (auto ok = checkMapFits(*numbers, *plan); !ok) return tl::unexpected(ok.error());

  CaseFromLabelsResult result;
  PatientCase& patient = result.patient;
  for (const TargetPlan& target : plan->targets) {
    const auto centre = centerOf(*numbers, target);
    const std::uint8_t label = plan->labels.count(target.number) ? plan->labels.at(target.number) : kBackground;
    if (centre)
      patient.manifest.targets.push_back({target.name, label, *centre});
    else
      result.notes.push_back("The target '" + target.name + "' was left out: number " + std::to_string(target.number) +
                             " is not in the slice at " + std::to_string(target.z_mm) + " mm.");
  }
  for (const auto& [number, name] : plan->vessels)
    if (auto course = courseOf(*numbers, number); !course.empty())
      patient.manifest.vessels.push_back({name, plan->labels.at(number), std::move(course)});
  if (!report(progress, "Completing the anatomy", 0)) return fail(std::string(kCancelled));
  if (plan->complete) fillMarrow(*labels);
  drawTubes(*labels, plan->tubes);
  if (plan->complete) {
    plan->complete->seed = ct.seed;
    if (auto done = completeAnatomy(*labels, *plan->complete); !done) return tl::unexpected(done.error());
  }
  auto volume = synthesizeCt(*labels, ct, progress);
  if (!volume) return tl::unexpected(volume.error());
  patient.ct = std::move(*volume);
  patient.labels = std::move(*labels);
  if (!plan->title.empty()) patient.manifest.title = plan->title;
  patient.manifest.source = "CT synthesized from a label map, seed " + std::to_string(ct.seed);
  addStartPoses(patient, result.notes);
  return result;
}

}  // namespace insonate
