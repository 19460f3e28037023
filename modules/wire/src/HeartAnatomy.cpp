#include "HeartAnatomy.h"

#include <insonate/cases/VesselName.h>
#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace insonate::wire {
namespace {

constexpr Vec3 kCaudal{0, 0, -1}, kCranial{0, 0, 1};
constexpr double kStep_mm = 3;

// Mean lengths and radii of adults: Standring S (ed), Gray's Anatomy, 42nd ed. 2020: right brachiocephalic vein 25 mm,
// left 60 mm, superior vena cava 70 mm and about 20 mm wide, inferior vena cava about 220 mm and 20 to 25 mm wide,
// common iliac vein 60 mm. The right atrium is taken as 40 mm wide; the external iliac vein as 100 mm long.
constexpr double kRightBrachiocephalic_mm = 25, kLeftBrachiocephalic_mm = 60, kBrachiocephalicRadius_mm = 6.5;
constexpr double kLeastCava_mm = 15;  // a shorter superior vena cava of a case is continued as if it were missing
constexpr double kSuperiorVenaCava_mm = 70, kVenaCavaRadius_mm = 10;
constexpr double kAtrium_mm = 45, kAtriumRadius_mm = 20;
constexpr double kInferiorVenaCava_mm = 220, kCommonIliac_mm = 60, kExternalIliac_mm = 100, kIliacRadius_mm = 6;
constexpr double kConfluence_mm =
    20;  // minimum length from the case's edge to the confluence, so that tubes bend smoothly
// Brachiocephalic trunk 40 mm; arch of the aorta 28 mm wide (same source).
constexpr double kTrunk_mm = 40, kTrunkRadius_mm = 6, kAortaRadius_mm = 13;

/// Cubic curve from `from` to `to` that begins and ends along the given unit directions.
void addCurve(NamedVessel& vessel, Vec3 from, Vec3 along, Vec3 to, Vec3 alongEnd, double radius0_mm,
              double radius1_mm) {
  const double length_mm = norm(to - from);
  const int pieces = std::max(2, static_cast<int>(std::ceil(length_mm / kStep_mm)));
  for (int i = vessel.course.empty() ? 0 : 1; i <= pieces; ++i) {
    const double t = static_cast<double>(i) / pieces, u = 1 - t;
    const Vec3 p = from * (u * u * (1 + 2 * t)) + along * (length_mm * t * u * u) + to * (t * t * (3 - 2 * t)) -
                   alongEnd * (length_mm * t * t * u);
    vessel.course.push_back({p, radius0_mm + (radius1_mm - radius0_mm) * t});
  }
}

NamedVessel curve(const char* name, std::uint8_t label, const TubeEnd& from, Vec3 to, Vec3 alongEnd, double radius_mm) {
  NamedVessel vessel{name, label, {}};
  addCurve(vessel, from.at_mm, from.outward, to, alongEnd, from.radius_mm, radius_mm);
  return vessel;
}

double lengthOf_mm(const NamedVessel& vessel) {
  double length_mm = 0;
  for (std::size_t i = 1; i < vessel.course.size(); ++i)
    length_mm += norm(vessel.course[i].position_mm - vessel.course[i - 1].position_mm);
  return length_mm;
}

/// The end nearest to the heart of a vessel above or below it.
TubeEnd heartEnd(const NamedVessel& vessel, bool isAbove) {
  const double first = vessel.course.front().position_mm.z, last = vessel.course.back().position_mm.z;
  return endOf(vessel, isAbove ? last < first : last > first);
}

const NamedVessel* find(std::span<const NamedVessel> vessels, std::uint8_t label, KnownVessel which, BodySide side) {
  for (const NamedVessel& vessel : vessels) {
    const VesselName name = parsedVesselName(vessel.name);
    if (vessel.label == label && vessel.course.size() > 1 && name.vessel == which && name.side == side) return &vessel;
  }
  return nullptr;
}

const NamedVessel* find(std::span<const NamedVessel> vessels, std::uint8_t label, std::string_view text,
                        std::string_view side = {}) {
  for (const NamedVessel& vessel : vessels)
    if (vessel.label == label && vessel.course.size() > 1 && vessel.name.find(text) != std::string::npos &&
        vessel.name.find(side) != std::string::npos)
      return &vessel;
  return nullptr;
}

/// The vein of one side that leads to the superior vena cava, and the length of its brachiocephalic part in the case.
struct Inlet {
  TubeEnd end;
  double inCase_mm = 0;
};

std::optional<Inlet> inletOf(std::span<const NamedVessel> vessels, BodySide side) {
  if (const auto* vein = find(vessels, kVein, KnownVessel::Brachiocephalic, side))
    return Inlet{heartEnd(*vein, true), lengthOf_mm(*vein)};
  if (const auto* vein = find(vessels, kVein, KnownVessel::InternalJugular, side)) return Inlet{heartEnd(*vein, true)};
  return std::nullopt;
}

/// Right atrium below `junction`, and the inferior vena cava below the atrium.
void addAtrium(HeartAnatomy& heart, Vec3 junction_mm) {
  NamedVessel atrium{"right atrium", kVein, {}};
  for (double s = 0; s <= kAtrium_mm; s += kStep_mm) {
    const double share = std::min(s / kAtriumRadius_mm, 1.0);
    atrium.course.push_back(
        {junction_mm + kCaudal * s, kVenaCavaRadius_mm + (kAtriumRadius_mm - kVenaCavaRadius_mm) * share});
  }
  const Vec3 floor_mm = atrium.course.back().position_mm;
  heart.beyond.push_back(std::move(atrium));
  heart.beyond.push_back(curve("inferior vena cava", kVein, {floor_mm, kCaudal, kVenaCavaRadius_mm},
                               floor_mm + kCaudal * kInferiorVenaCava_mm, kCaudal, kVenaCavaRadius_mm));
}

void addSuperiorVeins(std::span<const NamedVessel> vessels, HeartAnatomy& heart) {
  const NamedVessel* inCase = find(vessels, kVein, "superior vena cava");
  // A label map that ends at the confluence contains a stub without direction.
  if (inCase && std::abs(inCase->course.front().position_mm.z - inCase->course.back().position_mm.z) < kLeastCava_mm)
    inCase = nullptr;
  const auto right = inletOf(vessels, BodySide::Right), left = inletOf(vessels, BodySide::Left);
  TubeEnd cava;
  double cava_mm = kSuperiorVenaCava_mm;
  if (inCase) {
    cava = heartEnd(*inCase, true);
    cava_mm = std::max(kSuperiorVenaCava_mm - lengthOf_mm(*inCase), kConfluence_mm);
  } else {
    if (!right && !left) return;
    if (right) {
      const double length_mm = std::max(kRightBrachiocephalic_mm - right->inCase_mm, kConfluence_mm);
      cava.at_mm = right->end.at_mm + normalized(right->end.outward + kCaudal) * length_mm;
    } else {
      const double length_mm = std::max(kLeftBrachiocephalic_mm - left->inCase_mm, kConfluence_mm);
      cava.at_mm = left->end.at_mm + normalized(Vec3{-1, 0, -0.6}) * length_mm;
    }
    cava.outward = kCaudal, cava.radius_mm = 8;
    if (right)
      heart.vessels.push_back(
          curve("right brachiocephalic vein", kVein, right->end, cava.at_mm, kCaudal, kBrachiocephalicRadius_mm));
    if (left)
      heart.vessels.push_back(curve("left brachiocephalic vein", kVein, left->end, cava.at_mm,
                                    normalized(Vec3{-0.5, 0, -1}), kBrachiocephalicRadius_mm));
  }
  const Vec3 junction_mm = cava.at_mm + kCaudal * cava_mm;
  heart.vessels.push_back(curve("superior vena cava", kVein, cava, junction_mm, kCaudal, kVenaCavaRadius_mm));
  heart.veinsToHeart = junction_mm;
  addAtrium(heart, junction_mm);
}

void addInferiorVeins(std::span<const NamedVessel> vessels, HeartAnatomy& heart) {
  if (heart.veinsToHeart) return;
  std::optional<TubeEnd> cava;
  for (const char* side : {"right", "left"}) {
    const NamedVessel* vein = find(vessels, kVein, "femoral", side);
    if (!vein) continue;
    const TubeEnd femoral = heartEnd(*vein, false);
    const double toMidline = side[0] == 'r' ? 1 : -1;
    const Vec3 inward = normalized(Vec3{0.5 * toMidline, 0.4, 1});
    const Vec3 bend_mm = femoral.at_mm + inward * kExternalIliac_mm;
    if (!cava) cava = TubeEnd{bend_mm + inward * kCommonIliac_mm, kCranial, kVenaCavaRadius_mm};
    NamedVessel iliac{std::string(side) + " iliac vein", kVein, {}};
    addCurve(iliac, femoral.at_mm, femoral.outward, bend_mm, inward, femoral.radius_mm, kIliacRadius_mm);
    addCurve(iliac, bend_mm, inward, cava->at_mm, kCranial, kIliacRadius_mm, kIliacRadius_mm + 1);
    heart.vessels.push_back(std::move(iliac));
  }
  if (!cava) return;
  const Vec3 junction_mm = cava->at_mm + kCranial * kInferiorVenaCava_mm;
  heart.vessels.push_back(curve("inferior vena cava", kVein, *cava, junction_mm, kCranial, kVenaCavaRadius_mm));
  const Vec3 roof_mm = junction_mm + kCranial * kAtrium_mm;
  NamedVessel atrium{"right atrium", kVein, {{junction_mm, kVenaCavaRadius_mm}}};
  addCurve(atrium, junction_mm, kCranial, roof_mm, kCranial, kVenaCavaRadius_mm, kAtriumRadius_mm);
  heart.beyond.push_back(std::move(atrium));
  heart.beyond.push_back(curve("superior vena cava", kVein, {roof_mm, kCranial, kVenaCavaRadius_mm},
                               roof_mm + kCranial * kSuperiorVenaCava_mm, kCranial, kVenaCavaRadius_mm));
  heart.veinsToHeart = junction_mm;
}

void addArteries(std::span<const NamedVessel> vessels, HeartAnatomy& heart) {
  if (find(vessels, kArtery, "aort")) return;  // the case has its own arch
  struct Branch {
    KnownVessel vessel;
    BodySide side;
  };
  constexpr std::array<Branch, 4> kBranches{{{KnownVessel::CommonCarotid, BodySide::Right},
                                             {KnownVessel::Subclavian, BodySide::Right},
                                             {KnownVessel::CommonCarotid, BodySide::Left},
                                             {KnownVessel::Subclavian, BodySide::Left}}};
  std::array<std::optional<TubeEnd>, 4> ends;
  Vec3 sum{};
  int count = 0;
  double lowest_mm = 1e9;
  for (std::size_t b = 0; b < kBranches.size(); ++b)
    if (const auto* artery = find(vessels, kArtery, kBranches[b].vessel, kBranches[b].side)) {
      ends[b] = heartEnd(*artery, true);
      // The arch lies behind the middle; a single side stands for its mirror image.
      const double aside_mm = kBranches[b].side == BodySide::Right ? 14 : -14;
      sum = sum + ends[b]->at_mm + Vec3{aside_mm, 0, 0};
      lowest_mm = std::min(lowest_mm, ends[b]->at_mm.z);
      ++count;
    }
  if (count == 0) return;
  const double x = sum.x / count, y = sum.y / count, z = lowest_mm - kTrunk_mm;
  NamedVessel aorta{"arch of the aorta", kArtery, {}};
  const Vec3 root_mm{x - 8, y - 25, z - 70};
  const Vec3 rightTop_mm{x - 6, y - 12, z}, top_mm{x + 6, y + 2, z + 3}, leftTop_mm{x + 15, y + 14, z};
  addCurve(aorta, root_mm, kCranial, rightTop_mm, normalized(Vec3{0.5, 0.6, 0.6}), kAortaRadius_mm, kAortaRadius_mm);
  addCurve(aorta, rightTop_mm, normalized(Vec3{0.5, 0.6, 0.6}), leftTop_mm, normalized(Vec3{0.5, 0.6, -0.6}),
           kAortaRadius_mm, kAortaRadius_mm);
  addCurve(aorta, leftTop_mm, normalized(Vec3{0.5, 0.6, -0.6}), {x + 22, y + 28, z - 50}, kCaudal, kAortaRadius_mm,
           kAortaRadius_mm);
  addCurve(aorta, {x + 22, y + 28, z - 50}, kCaudal, {x + 18, y + 28, z - 200}, kCaudal, kAortaRadius_mm, 11);
  heart.vessels.push_back(std::move(aorta));
  if (ends[0] || ends[1]) {
    const Vec3 fork_mm =
        (ends[0] && ends[1] ? (ends[0]->at_mm + ends[1]->at_mm) / 2 : (ends[0] ? ends[0] : ends[1])->at_mm) +
        kCaudal * 8;
    for (const std::size_t b : {0, 1})
      if (ends[b])
        heart.vessels.push_back(curve(b == 0 ? "right common carotid artery" : "right subclavian artery", kArtery,
                                      *ends[b], fork_mm, kCaudal, ends[b]->radius_mm));
    heart.vessels.push_back(curve("brachiocephalic trunk", kArtery, {fork_mm, kCaudal, kTrunkRadius_mm}, rightTop_mm,
                                  kCaudal, kTrunkRadius_mm));
  }
  if (ends[2])
    heart.vessels.push_back(
        curve("left common carotid artery", kArtery, *ends[2], top_mm, kCaudal, ends[2]->radius_mm));
  if (ends[3]) heart.vessels.push_back(curve("left subclavian artery", kArtery, *ends[3], leftTop_mm, kCaudal, 5));
  heart.arteriesToHeart = root_mm;
}

}  // namespace

TubeEnd endOf(const NamedVessel& vessel, bool last) {
  const auto& course = vessel.course;
  const auto& end = last ? course.back() : course.front();
  const auto& inner = last ? course[course.size() - 2] : course[1];
  const Vec3 outward = end.position_mm - inner.position_mm;
  return {end.position_mm, norm(outward) > 0 ? normalized(outward) : Vec3{0, 0, last ? 1.0 : -1.0}, end.radius_mm};
}

HeartAnatomy heartAnatomy(std::span<const NamedVessel> vessels) {
  HeartAnatomy heart;
  addSuperiorVeins(vessels, heart);
  addInferiorVeins(vessels, heart);
  addArteries(vessels, heart);
  return heart;
}

}  // namespace insonate::wire
