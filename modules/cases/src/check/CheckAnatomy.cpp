#include "Checks.h"

#include <insonate/cases/VesselName.h>
#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace insonate::check {
namespace {

/// A vessel or a target whose name states a side; mean position and ends in patient LPS, where x grows to the left.
struct SidedPlace {
  std::string what, name;
  std::uint8_t label;
  Vec3 middle_mm;
  double lowest_mm, highest_mm;  ///< range of z
};

constexpr double kAtLevel_mm = 5;

/// A vessel on the wrong side is an error beyond this distance from the midline. The trachea may deviate from the
/// midline by some millimeters.
constexpr double kWrongSide_mm = 10;

/// A jugular vein that lies medial of the carotid artery by more than this is a warning: of 200 patients, the vein was
/// lateral and anterior in 92 % and medial in 2 % (Denys and Uretsky, Crit Care Med 1991; 19: 1516-9). The tolerance is
/// our choice, since centers of vessels that overlap may differ by some millimeters.
constexpr double kMedial_mm = 3;

/// Internal jugular vein and carotid artery run from the skull base to the thoracic inlet (Gray's Anatomy). A course
/// that is this far from the head-foot direction is a warning; the angle and the length that it needs are our choice.
constexpr double kSteepest_deg = 60, kShortest_mm = 15;

/// Returns -1 for right, 1 for left (the sign of x in LPS), and 0 if the name states no side or both.
int sideIn(const std::string& name) {
  const auto side = parsedVesselName(name).side;
  if (!side) return 0;
  return side == BodySide::Left ? 1 : -1;
}

std::string sideName(int side) {
  return side < 0 ? "right" : "left";
}

SidedPlace placeOfVessel(const NamedVessel& vessel) {
  SidedPlace place{"The " + vessel.name,          vessel.name, vessel.label, {}, vessel.course[0].position_mm.z,
                   vessel.course[0].position_mm.z};
  for (const NamedVessel::Point& point : vessel.course) {
    place.middle_mm = place.middle_mm + point.position_mm * (1.0 / static_cast<double>(vessel.course.size()));
    place.lowest_mm = std::min(place.lowest_mm, point.position_mm.z);
    place.highest_mm = std::max(place.highest_mm, point.position_mm.z);
  }
  return place;
}

/// Sum of positions along x, and their number.
struct MeanX {
  double sum_mm = 0;
  std::size_t count = 0;

  void add(const MeanX& other) { sum_mm += other.sum_mm, count += other.count; }
  double mean_mm() const { return sum_mm / static_cast<double>(count); }
};

/// Body and airway in one slice; both are empty if the volume cuts the body there, since its center is not its midline.
struct SliceCenters {
  double z_mm;
  MeanX body, airway;
};

bool isCut(const LabelMap& labels, int k) {
  const int last = labels.geometry.size[0] - 1;
  for (int j = 0; j < labels.geometry.size[1]; ++j)
    if (labels.at(0, j, k) != kBackground || labels.at(last, j, k) != kBackground) return true;
  return false;
}

/// Reads the whole label map once, for all vessels and targets.
std::vector<SliceCenters> centersOf(const LabelMap& labels) {
  const VolumeGeometry& g = labels.geometry;
  const auto toPatient = g.patientFromIndex();
  std::vector<SliceCenters> slices;
  for (int k = 0; k < g.size[2]; ++k) {
    slices.push_back({(toPatient * Vec3{g.size[0] / 2.0, g.size[1] / 2.0, double(k)}).z, {}, {}});
    if (isCut(labels, k)) continue;
    for (int j = 0; j < g.size[1]; ++j) {
      const double first = (toPatient * Vec3{0, double(j), double(k)}).x;
      const double step = (toPatient * Vec3{1, double(j), double(k)}).x - first;
      for (int i = 0; i < g.size[0]; ++i) {
        const std::uint8_t label = labels.at(i, j, k);
        if (label != kBackground) slices.back().body.add({first + i * step, 1});
        if (label == kAirway) slices.back().airway.add({first + i * step, 1});
      }
    }
  }
  return slices;
}

/// Returns the mean x of the body and of its airway at the levels of a vessel; no entry for what is not known there.
std::vector<double> centersAt(const std::vector<SliceCenters>& slices, const SidedPlace& place) {
  MeanX body, airway;
  for (const SliceCenters& slice : slices) {
    if (slice.z_mm < place.lowest_mm - kAtLevel_mm || slice.z_mm > place.highest_mm + kAtLevel_mm) continue;
    body.add(slice.body);
    airway.add(slice.airway);
  }
  std::vector<double> centers;
  if (body.count > 0) centers.push_back(body.mean_mm());
  if (airway.count > 0) centers.push_back(airway.mean_mm());
  return centers;
}

/// A scan of one arm contains no midline of the body.
bool isOfArm(const std::string& name) {
  constexpr std::array kOfArm{KnownVessel::Basilic, KnownVessel::Brachial, KnownVessel::Cephalic};
  const auto vessel = parsedVesselName(name).vessel;
  return vessel && std::ranges::find(kOfArm, *vessel) != kOfArm.end();
}

void checkSide(const CaseView& patient, const std::vector<SliceCenters>& slices, const SidedPlace& place,
               Findings& findings) {
  const int side = sideIn(place.name);
  if (side == 0 || isOfArm(place.name) || !inVolume(patient.labels.geometry, place.middle_mm)) return;
  const auto centers = centersAt(slices, place);
  // Both centers must agree, since the airway includes the lungs, which may be labeled on one side only.
  const auto isBeyond = [&](double center_mm) { return side * (place.middle_mm.x - center_mm) < -kWrongSide_mm; };
  if (centers.empty() || !std::ranges::all_of(centers, isBeyond)) return;
  findings.push_back({FindingSeverity::kError, "wrong_side",
                      place.what + " lies on the patient's " + sideName(-side) + ", " +
                          std::to_string(std::lround(std::abs(place.middle_mm.x - centers.back()))) +
                          " mm from the midline. Correct its name or its position. If other structures are on the "
                          "wrong side, too, the CT is mirrored: import it again.",
                      place.middle_mm, place.label});
}

/// Returns the mean x of the part of a vessel that lies at a level, or no value.
std::optional<double> xAt(const NamedVessel& vessel, double z_mm) {
  for (std::size_t i = 0; i + 1 < vessel.course.size(); ++i) {
    const Vec3 a = vessel.course[i].position_mm, b = vessel.course[i + 1].position_mm;
    if (a.z == b.z || z_mm < std::min(a.z, b.z) || z_mm > std::max(a.z, b.z)) continue;
    return a.x + (b.x - a.x) * (z_mm - a.z) / (b.z - a.z);
  }
  return std::nullopt;
}

void checkNeighbor(const NamedVessel& vein, const NamedVessel& artery, Findings& findings) {
  const int side = sideIn(vein.name);
  double medial_mm = 0;
  int levels = 0;
  for (const NamedVessel::Point& point : vein.course)
    if (const auto x_mm = xAt(artery, point.position_mm.z)) {
      medial_mm += side * (*x_mm - point.position_mm.x);
      ++levels;
    }
  if (levels == 0 || medial_mm / levels <= kMedial_mm) return;
  findings.push_back({FindingSeverity::kWarning, "vein_medial",
                      "The " + vein.name + " lies " + std::to_string(std::lround(medial_mm / levels)) +
                          " mm medial of the " + artery.name +
                          ". In 2 % of patients the vein is medial; in all others, vein and artery are interchanged. "
                          "Compare vein and artery on the slices.",
                      vein.course.front().position_mm, vein.label});
}

void checkDirection(const NamedVessel& vessel, Findings& findings) {
  const Vec3 along = vessel.course.back().position_mm - vessel.course.front().position_mm;
  const double length_mm = norm(along);
  if (length_mm < kShortest_mm) return;
  const double angle_deg = std::acos(std::min(1.0, std::abs(along.z) / length_mm)) * 180 / std::numbers::pi;
  if (angle_deg <= kSteepest_deg) return;
  findings.push_back(
      {FindingSeverity::kWarning, "vessel_direction",
       "The " + vessel.name + " runs at " + std::to_string(std::lround(angle_deg)) +
           " degrees to the head-foot direction. This vessel runs from head to foot. Check that no other "
           "vessel has its name.",
       vessel.course.front().position_mm, vessel.label});
}

}  // namespace

void checkAnatomy(const CaseView& patient, Findings& findings) {
  const CaseManifest& m = patient.manifest;
  if (m.targets.empty() && m.vessels.empty()) return;
  const std::vector<SliceCenters> slices = centersOf(patient.labels);
  for (const Target& target : m.targets)
    checkSide(patient, slices,
              {"The target \"" + target.name + "\"", target.name, target.label, target.position_mm,
               target.position_mm.z, target.position_mm.z},
              findings);
  const auto isJugular = [](const NamedVessel& v) {
    return v.label == kVein && parsedVesselName(v.name).vessel == KnownVessel::InternalJugular;
  };
  const auto isCarotid = [](const NamedVessel& v) {
    const auto vessel = parsedVesselName(v.name).vessel;
    return v.label == kArtery && (vessel == KnownVessel::Carotid || vessel == KnownVessel::CommonCarotid ||
                                  vessel == KnownVessel::InternalCarotid);
  };
  for (const NamedVessel& vessel : m.vessels) {
    if (vessel.course.empty()) continue;
    checkSide(patient, slices, placeOfVessel(vessel), findings);
    if (isJugular(vessel) || isCarotid(vessel)) checkDirection(vessel, findings);
    if (!isJugular(vessel) || sideIn(vessel.name) == 0) continue;
    for (const NamedVessel& artery : m.vessels)
      if (isCarotid(artery) && sideIn(artery.name) == sideIn(vessel.name)) checkNeighbor(vessel, artery, findings);
  }
}

}  // namespace insonate::check
