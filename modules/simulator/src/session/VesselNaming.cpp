#include <insonate/segmentation/CenterLine.h>
#include <insonate/simulator/VesselNaming.h>
#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace insonate {
namespace {

constexpr double kSectionStep_mm = 0.5;
/// A section that extends farther than this opens into another vessel.
constexpr double kSectionReach_mm = 20;
constexpr int kReach = static_cast<int>(kSectionReach_mm / kSectionStep_mm), kAcross = 2 * kReach + 1;

/// A section of the label perpendicular to `along`: the connected part that contains the center.
double sectionArea_mm2(const LabelMap& labels, std::uint8_t label, Vec3 middle_mm, Vec3 along) {
  const Transform indexFromPatient = labels.geometry.indexFromPatient();
  const Vec3 right = normalized(cross(along, std::abs(along.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
  const Vec3 down = cross(along, right);
  const auto isLabel = [&](int u, int v) {
    const Vec3 at_mm = middle_mm + right * (u * kSectionStep_mm) + down * (v * kSectionStep_mm);
    return sampleNearest(labels, indexFromPatient * at_mm) == label;
  };
  std::vector<bool> seen(std::size_t(kAcross) * kAcross);
  std::vector<std::array<int, 2>> open;
  const auto visit = [&](int u, int v) {
    if (std::abs(u) > kReach || std::abs(v) > kReach) return;
    const std::size_t at = std::size_t(v + kReach) * kAcross + std::size_t(u + kReach);
    if (seen[at] || !isLabel(u, v)) return;
    seen[at] = true;
    open.push_back({u, v});
  };
  visit(0, 0);
  std::size_t count = 0;
  while (!open.empty()) {
    const auto [u, v] = open.back();
    open.pop_back();
    ++count;
    visit(u - 1, v), visit(u + 1, v), visit(u, v - 1), visit(u, v + 1);
  }
  return double(count) * kSectionStep_mm * kSectionStep_mm;
}

std::size_t nearestPoint(const CenterLine& line, Vec3 place_mm) {
  const auto nearest = std::ranges::min_element(line, {}, [&](Vec3 point_mm) { return norm(point_mm - place_mm); });
  return std::size_t(nearest - line.begin());
}

std::vector<NamedVessel::Point> courseOf(const LabelMap& labels, std::uint8_t label, const CenterLine& line) {
  std::vector<NamedVessel::Point> course;
  for (std::size_t n = 0; n < line.size(); ++n) {
    const Vec3 along = line[std::min(n + 1, line.size() - 1)] - line[n > 0 ? n - 1 : 0];
    const double area_mm2 = norm(along) > 0 ? sectionArea_mm2(labels, label, line[n], normalized(along)) : 0;
    // The center of a bent or forked section may lie outside the label.
    if (area_mm2 > 0) course.push_back({line[n], std::sqrt(area_mm2 / std::numbers::pi)});
  }
  return course;
}

}  // namespace

std::span<const VesselKind> vesselKinds() {
  static constexpr std::array kKinds{VesselKind{"right internal jugular vein", kVein},
                                     VesselKind{"left internal jugular vein", kVein},
                                     VesselKind{"right external jugular vein", kVein},
                                     VesselKind{"left external jugular vein", kVein},
                                     VesselKind{"right subclavian vein", kVein},
                                     VesselKind{"left subclavian vein", kVein},
                                     VesselKind{"right axillary vein", kVein},
                                     VesselKind{"left axillary vein", kVein},
                                     VesselKind{"right brachiocephalic vein", kVein},
                                     VesselKind{"left brachiocephalic vein", kVein},
                                     VesselKind{"right common femoral vein", kVein},
                                     VesselKind{"left common femoral vein", kVein},
                                     VesselKind{"right great saphenous vein", kVein},
                                     VesselKind{"left great saphenous vein", kVein},
                                     VesselKind{"right basilic vein", kVein},
                                     VesselKind{"left basilic vein", kVein},
                                     VesselKind{"right common carotid artery", kArtery},
                                     VesselKind{"left common carotid artery", kArtery},
                                     VesselKind{"right subclavian artery", kArtery},
                                     VesselKind{"left subclavian artery", kArtery},
                                     VesselKind{"right vertebral artery", kArtery},
                                     VesselKind{"left vertebral artery", kArtery},
                                     VesselKind{"right common femoral artery", kArtery},
                                     VesselKind{"left common femoral artery", kArtery},
                                     VesselKind{"right brachial artery", kArtery},
                                     VesselKind{"left brachial artery", kArtery}};
  return kKinds;
}

Result<NamedVessel> nameVessel(const LabelMap& labels, const OwnLabels& own, Vec3 place_mm, std::string name,
                               const Progress& progress) {
  const std::uint8_t label = sampleNearest(labels, labels.geometry.indexFromPatient() * place_mm);
  const std::uint8_t tissue = tissueOf(own, label);
  if (tissue != kVein && tissue != kArtery)
    return fail("The location of the " + name + " is in no vein or artery. Move the crosshair into the vessel first.");
  const auto lines = centerLines(labels, label, progress);
  if (!lines) return tl::unexpected(lines.error());
  const auto distance_mm = [&](const CenterLine& line) { return norm(line[nearestPoint(line, place_mm)] - place_mm); };
  const auto line = std::ranges::min_element(*lines, {}, distance_mm);
  NamedVessel vessel{std::move(name), tissue, {}};
  if (line != lines->end() && distance_mm(*line) < kSectionReach_mm) vessel.course = courseOf(labels, label, *line);
  if (vessel.course.empty())
    return fail("The " + vessel.name + " is too short to have a center line. Label a longer part of the vessel first.");
  return vessel;
}

Result<NamedVessel> longestVessel(const LabelMap& labels, std::uint8_t label, std::string name,
                                  const Progress& progress) {
  const auto lines = centerLines(labels, label, progress);
  if (!lines) return tl::unexpected(lines.error());
  const auto length_mm = [](const CenterLine& line) {
    double sum = 0;
    for (std::size_t n = 1; n < line.size(); ++n) sum += norm(line[n] - line[n - 1]);
    return sum;
  };
  NamedVessel vessel{std::move(name), label, {}};
  if (const auto line = std::ranges::max_element(*lines, {}, length_mm); line != lines->end())
    vessel.course = courseOf(labels, label, *line);
  if (vessel.course.empty())
    return fail("The " + vessel.name + " is too short to have a center line, and has no name.");
  return vessel;
}

Result<std::pair<NamedVessel, NamedVessel>> splitVessel(const NamedVessel& vessel, Vec3 place_mm) {
  const auto cut = std::ranges::min_element(
      vessel.course, {}, [&](const NamedVessel::Point& point) { return norm(point.position_mm - place_mm); });
  if (cut == vessel.course.begin() || cut >= vessel.course.end() - 1)
    return fail("The crosshair is at an end of the " + vessel.name +
                ". Move the crosshair to the point where the name changes.");
  std::pair parts{NamedVessel{vessel.name, vessel.label, {vessel.course.begin(), cut + 1}},
                  NamedVessel{vessel.name, vessel.label, {cut, vessel.course.end()}}};
  for (const Vec3& click_mm : vessel.clicks_mm) {
    const bool isFirst =
        distanceToCenterLine_mm(parts.first, click_mm) <= distanceToCenterLine_mm(parts.second, click_mm);
    (isFirst ? parts.first : parts.second).clicks_mm.push_back(click_mm);
  }
  return parts;
}

Result<std::vector<NamedVessel>> vesselsFromGuide(const Guide& guide, const Recipe& recipe, const LabelMap& labels,
                                                  const OwnLabels& own, const Progress& progress) {
  std::vector<NamedVessel> vessels;
  for (const GuideStep& step : guide.steps) {
    const std::vector<Vec3> clicks_mm = step.vessel.empty() ? std::vector<Vec3>{} : clicksOf(step, recipe);
    const auto inside = std::ranges::find_if(clicks_mm, [&](Vec3 click_mm) {
      return tissueOf(own, sampleNearest(labels, labels.geometry.indexFromPatient() * click_mm)) == step.label;
    });
    if (inside == clicks_mm.end()) continue;
    auto vessel = nameVessel(labels, own, *inside, step.vessel, progress);
    if (!vessel && vessel.error().message == kCancelled) return tl::unexpected(vessel.error());
    if (!vessel) continue;
    vessel->clicks_mm = clicks_mm;
    vessels.push_back(std::move(*vessel));
  }
  return vessels;
}

void addOrReplaceVessel(NamedVessel vessel, std::vector<NamedVessel>& vessels) {
  const auto same = std::ranges::find(vessels, vessel.name, &NamedVessel::name);
  if (same == vessels.end())
    vessels.push_back(std::move(vessel));
  else
    *same = std::move(vessel);
}

}  // namespace insonate
