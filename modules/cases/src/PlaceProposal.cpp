#include "NeckLevel.h"

#include <insonate/cases/Difficulty.h>
#include <insonate/cases/Landmarks.h>
#include <insonate/cases/PlaceProposal.h>
#include <insonate/cases/StartPose.h>
#include <insonate/cases/TissueLabels.h>
#include <insonate/cases/VesselName.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

namespace insonate {
namespace {

/// A pose whose beam passes within this distance of a target lies over this target.
constexpr double kOver_mm = 12;

/// Veins into which procedures lead.
constexpr std::array kPunctured{KnownVessel::InternalJugular, KnownVessel::Jugular, KnownVessel::Subclavian,
                                KnownVessel::Axillary,        KnownVessel::Femoral, KnownVessel::Basilic};

bool isPunctured(const NamedVessel& vessel) {
  const VesselName name = parsedVesselName(vessel.name);
  return vessel.label == kVein && name.vessel && std::ranges::find(kPunctured, *name.vessel) != kPunctured.end();
}

/// Jugular veins without a closer name are internal ones: the others are not punctured.
KnownVessel kindOf(const NamedVessel& vessel) {
  const KnownVessel kind = parsedVesselName(vessel.name).vessel.value();
  return kind == KnownVessel::Jugular ? KnownVessel::InternalJugular : kind;
}

bool isIn(const NamedVessel& vessel, const Target& target) {
  return vessel.label == target.label &&
         (namesVessel(target.name, vessel.name) || distanceToWall_mm(vessel, target.position_mm) <= 0);
}

double distanceToEdge_mm(const VolumeGeometry& grid, Vec3 place_mm) {
  const Vec3 index = grid.indexFromPatient() * place_mm;
  double nearest_mm = std::numeric_limits<double>::infinity();
  for (int a = 0; a < 3; ++a)
    nearest_mm =
        std::min({nearest_mm, index[a] * grid.spacing_mm[a], (grid.size[a] - 1 - index[a]) * grid.spacing_mm[a]});
  return nearest_mm;
}

/// The vessel's direction at the point of its course that is nearest to a place.
Vec3 directionAt(const NamedVessel& vessel, Vec3 place_mm) {
  const auto nearest = std::ranges::min_element(
      vessel.course, {}, [&](const NamedVessel::Point& point) { return norm(point.position_mm - place_mm); });
  constexpr std::ptrdiff_t kReach = 5;
  const auto first = nearest - std::min(kReach, nearest - vessel.course.begin());
  const auto last = nearest + std::min(kReach, std::prev(vessel.course.end()) - nearest);
  const Vec3 along = last->position_mm - first->position_mm;
  return norm(along) > 1e-6 ? normalized(along) : Vec3{0, 0, 1};
}

/// Cost of a puncture, in millimeters of depth. The weights are our choice: 10 % of an artery behind the vein, 10 mm2
/// less of an area below 100 mm2, or 5 mm from the neck's narrowest level cost as much as 1 mm of depth. A lung within
/// 10 mm behind the vein costs as much as 20 mm.
double costOf_mm(const VeinMeasures& measured, double offLevel_mm) {
  constexpr double kLarge_mm2 = 100, kLung_mm = 10;
  const double artery_percent = std::max(measured.overlap_percent.value_or(0), measured.covered_percent.value_or(0));
  return measured.depth_mm + artery_percent / 10 + std::max(0.0, kLarge_mm2 - measured.area_mm2) / 10 +
         offLevel_mm / 5 + (measured.lung_mm && *measured.lung_mm < kLung_mm ? 20 : 0);
}

struct Candidate {
  Target target;
  double cost_mm = 0;
};

/// Looks along the vein every few millimeters. Its ends, and the edge of the volume, are left out while the middle
/// serves: there the image would show only a part of the vein.
std::optional<Candidate> targetIn(const CaseView& patient, const NamedVessel& vessel, std::optional<double> level_mm) {
  constexpr double kEvery_mm = 4, kEdge_mm = 15;
  const Transform index = patient.labels.geometry.indexFromPatient();
  const Vec3 first_mm = vessel.course.front().position_mm, last_mm = vessel.course.back().position_mm;
  std::optional<Candidate> best;
  Vec3 looked_mm{1e9, 1e9, 1e9};
  for (const NamedVessel::Point& point : vessel.course) {
    const Vec3 here_mm = point.position_mm;
    if (norm(here_mm - looked_mm) < kEvery_mm || sampleNearest(patient.labels, index * here_mm) != vessel.label)
      continue;
    looked_mm = here_mm;
    const Target target{vessel.name, vessel.label, here_mm};
    const auto measured = measureVein(patient, target);
    if (!measured) continue;
    const double toEnd_mm = std::min(
        {norm(here_mm - first_mm), norm(here_mm - last_mm), distanceToEdge_mm(patient.labels.geometry, here_mm)});
    const double offLevel_mm =
        level_mm && kindOf(vessel) == KnownVessel::InternalJugular ? std::abs(here_mm.z - *level_mm) : 0;
    const double cost_mm = costOf_mm(*measured, offLevel_mm) + 2 * std::max(0.0, kEdge_mm - toEnd_mm);
    if (!best || cost_mm < best->cost_mm) best = Candidate{target, cost_mm};
  }
  return best;
}

bool isOver(const StartPose& pose, const Target& target) {
  const Vec3 to = target.position_mm - pose.position_mm;
  const double deep_mm = dot(to, pose.axial);
  return deep_mm > 0 && norm(to - deep_mm * pose.axial) <= kOver_mm;
}

/// The image plane of the transverse pose is perpendicular to a vessel across the body, e.g. the axillary vein.
StartPose acrossVessel(StartPose pose, Vec3 along) {
  if (std::abs(along.z) > std::abs(along.x)) return pose;
  const Vec3 feet{0, 0, -1};
  pose.lateral = normalized(feet - dot(feet, pose.axial) * pose.axial);
  return pose;
}

Result<void> proposeTargets(const CaseView& patient, PlaceProposal& proposal, const Progress& progress) {
  if (!patient.manifest.targets.empty()) return {};
  const auto [level, isNeck] = neckOrMiddle(bodyLevels(PatientBody(patient), patient.ct.geometry));
  std::vector<const NamedVessel*> veins;
  for (const NamedVessel& vessel : patient.manifest.vessels)
    if (isPunctured(vessel)) veins.push_back(&vessel);
  std::ranges::stable_sort(
      veins, {}, [](const NamedVessel* vessel) { return parsedVesselName(vessel->name).side == BodySide::Left; });
  std::vector<std::optional<Candidate>> found;
  for (const NamedVessel* vessel : veins) {
    if (!report(progress, "Looking for a target in the " + vessel->name, double(found.size()) / double(veins.size())))
      return fail(std::string(kCancelled));
    found.push_back(targetIn(patient, *vessel, isNeck ? std::optional(level.z_mm) : std::nullopt));
  }
  const auto costAt = [&](std::size_t n) {
    return found[n] ? found[n]->cost_mm : std::numeric_limits<double>::infinity();
  };
  std::size_t easiest = 0;
  for (std::size_t n = 1; n < veins.size(); ++n)
    if (costAt(n) < costAt(easiest)) easiest = n;
  for (std::size_t n = 0; n < veins.size(); ++n)
    if (kindOf(*veins[n]) != kindOf(*veins[easiest]))
      continue;
    else if (found[n])
      proposal.targets.push_back(found[n]->target);
    else
      proposal.notes.push_back("No target was found in the " + veins[n]->name +
                               ": its center line is not labeled as vein, or there is no skin in front of it.");
  return {};
}

void proposeStartPoses(const CaseView& patient, PlaceProposal& proposal) {
  std::vector<Target> targets = patient.manifest.targets;
  targets.insert(targets.end(), proposal.targets.begin(), proposal.targets.end());
  for (const Target& target : targets) {
    if (std::ranges::any_of(patient.manifest.startPoses, [&](const StartPose& pose) { return isOver(pose, target); }))
      continue;
    const auto pose = proposeStartPoseOver(patient, target);
    if (!pose) {
      proposal.notes.push_back("No start pose over the " + target.name + ": " + pose.error().message);
      continue;
    }
    const auto vessel =
        std::ranges::find_if(patient.manifest.vessels, [&](const NamedVessel& one) { return isIn(one, target); });
    const Vec3 along = vessel == patient.manifest.vessels.end() || vessel->course.empty()
                           ? Vec3{0, 0, 1}
                           : directionAt(*vessel, target.position_mm);
    StartPose transverse = acrossVessel(*pose, along), longitudinal = longitudinalPose(*pose, along);
    transverse.name = target.name + ", transverse";
    longitudinal.name = target.name + ", longitudinal";
    proposal.startPoses.push_back(std::move(transverse));
    proposal.startPoses.push_back(std::move(longitudinal));
  }
}

void proposeLandmarks(const CaseView& patient, PlaceProposal& proposal) {
  const LandmarkKind* kind = landmarkKind("puncture_site");
  const auto& known = patient.manifest.landmarks;
  if (std::ranges::find(known, std::string(kind->code), &Landmark::code) != known.end()) return;
  const auto& poses = patient.manifest.startPoses.empty() ? proposal.startPoses : patient.manifest.startPoses;
  if (!poses.empty())
    proposal.landmarks.push_back({std::string(kind->code), std::string(kind->name), poses.front().position_mm});
}

}  // namespace

StartPose longitudinalPose(const StartPose& transverse, Vec3 along) {
  const bool isAcross = std::abs(along.z) <= std::abs(along.x);
  const Vec3 right = isAcross ? Vec3{1, 0, 0} : Vec3{0, 0, -1};
  const Vec3 toward = dot(along, right) < 0 ? -along : along;
  Vec3 lateral = toward - dot(toward, transverse.axial) * transverse.axial;
  if (norm(lateral) < 0.2) lateral = right - dot(right, transverse.axial) * transverse.axial;
  StartPose pose = transverse;
  pose.lateral = normalized(lateral);
  return pose;
}

Result<PlaceProposal> proposePlaces(const CaseView& authors, const Progress& progress) {
  if (authors.labels.geometry.size != authors.ct.geometry.size)
    return fail("The CT and the labels are on different grids; no places can be proposed.");
  const auto tissues = withTissueLabels(authors.manifest.ownLabels, authors.labels);
  // measureVein() would measure along a start pose that the author has placed; targets do not depend on it.
  CaseManifest plain = authors.manifest;
  plain.startPoses.clear();
  const LabelMap& labels = tissues ? *tissues : authors.labels;
  PlaceProposal proposal;
  if (const auto done = proposeTargets({plain, authors.ct, labels}, proposal, progress); !done)
    return tl::unexpected(done.error());
  const CaseView patient(authors.manifest, authors.ct, labels);
  proposeStartPoses(patient, proposal);
  proposeLandmarks(patient, proposal);
  return proposal;
}

void addPlaces(PlaceProposal proposal, CaseManifest& manifest) {
  const auto append = [](auto& from, auto& to) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
  };
  append(proposal.targets, manifest.targets);
  append(proposal.startPoses, manifest.startPoses);
  append(proposal.landmarks, manifest.landmarks);
}

}  // namespace insonate
