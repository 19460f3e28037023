#include "Groin.h"
#include "phantom/Variation.h"

#include <insonate/core/Hash.h>

#include <algorithm>
#include <cmath>

namespace insonate::phantom {
namespace {

// Levels, mm from the ligament over the artery. The saphenofemoral junction lies 24 mm lateral of the pubic tubercle
// and 10 mm below it: Mirjalili et al., Clin Anat 2014, doi 10.1002/ca.22386, 100 adults. The deep femoral artery
// leaves 20 to 50 mm below the ligament (Gray's Anatomy).
constexpr double kJunction_mm = -39, kBifurcation_mm = -44, kDeepVein_mm = -58;
constexpr double kUpperEnd_mm = 30, kLowerEnd_mm = -90;
/// The thrombus fills the whole vein below this level, and ends in a tail.
constexpr double kThrombusFills_mm = -51, kThrombusTail_mm = -43, kThrombusEnd_mm = -74;

/// Share of the overlap at a level: artery and vein lie side by side at the ligament, and one behind the other in the
/// thigh.
double overlapAt(double z_mm) {
  const double t = std::clamp((4 - z_mm) / 18, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

struct Line {
  std::string_view name;
  std::vector<Tube::Knot> knots;
};

/// Common femoral artery: 9 mm wide; it is 8 to 10 mm wide in adults and grows with age and size of the body (Sandgren
/// et al., J Vasc Surg 1999;29:503, 122 persons).
std::vector<Line> femoralArteries(const GroinParameters& n) {
  // `share` of the shift of the common femoral artery.
  const auto on = [&](double z, double x, double y, double r, double share = 1) {
    const double covered = share * n.overlap * overlapAt(z);
    const auto [awayX, awayY] = tortuosity_mm(n.seed + 1, z, 0.5);
    return Tube::Knot{{x + awayX - 8.2 * covered, y + awayY - 1.6 * covered, z}, r * n.arteryScale};
  };
  constexpr double b = kBifurcation_mm;
  std::vector<Tube::Knot> iliac{on(kUpperEnd_mm, -3, 28, 4.2), on(20, -1.4, 23, 4.2), on(10, 0.2, 17, 4.2),
                                on(0, 0.7, 12, 4.3)};
  std::vector<Tube::Knot> common{iliac.back(),           on(-8, 0.9, 10, 4.4),    on(-18, 0.9, 9.3, 4.5),
                                 on(-30, 1.2, 9.6, 4.6), on(-38, 1.6, 10.1, 4.8), on(b, 2, 10.6, 4.4)};
  return {{"external iliac artery", std::move(iliac)},
          {"common femoral artery", std::move(common)},
          {"superficial femoral artery",
           {on(b, 1.2, 10, 3.8), on(b - 8, 0.6, 10, 3.4), on(b - 18, -0.4, 10.8, 3.3), on(b - 30, -1.4, 12.2, 3.2),
            on(kLowerEnd_mm, -2.8, 14.2, 3.1)}},
          {"deep femoral artery",
           {on(b, 3, 11.6, 3.4), on(b - 7, 5.4, 15.6, 3, 0.5), on(b - 16, 7.4, 20, 2.8, 0.2),
            on(b - 28, 8.4, 26, 2.6, 0.1), on(kLowerEnd_mm, 8, 33, 2.4, 0.1)}},
          {"inferior epigastric artery",
           {on(5, -1, 12.4, 1.2), {{-5, 10.2, 9}, 1.1}, {{-11, 9.6, 17}, 1.1}, {{-17, 9.4, kUpperEnd_mm}, 1.1}}}};
}

std::vector<Tube::Knot> saphenousVein(const GroinParameters& n) {
  const auto vein = femoralVeinAt(n, kJunction_mm);
  // In the fat just above the fascia, which falls away toward the inner thigh.
  return {{{vein[0] - 0.5, vein[1] - 1.5, kJunction_mm + 1}, 2.6},
          {{vein[0] - 2, 5, kJunction_mm - 0.5}, 2.6},
          {{-15, 0.6, kJunction_mm - 3}, 2.4},
          {{-19, -1.6, kJunction_mm - 10}, 2.2},
          {{-23.5, -0.9, kJunction_mm - 22}, 2.1},
          {{-27.5, 0.4, kJunction_mm - 36}, 2},
          {{-31, 1.8, kLowerEnd_mm}, 2}};
}

std::vector<Tube::Knot> deepVein(const GroinParameters& n) {
  const auto vein = femoralVeinAt(n, kDeepVein_mm);
  return {{{vein[0], vein[1] + 1, kDeepVein_mm + 2}, 2.8},
          {{vein[0] + 3, vein[1] + 6, kDeepVein_mm - 7}, 2.6},
          {{0.6, 29.5, kDeepVein_mm - 19}, 2.4},
          {{1.6, 36, kLowerEnd_mm}, 2.4}};
}

Shape mainVein(const GroinParameters& n, std::uint32_t seed) {
  std::vector<Curve<5>::Knot> knots;
  for (double z = kLowerEnd_mm; z <= kUpperEnd_mm; z += 5) knots.push_back({z, femoralVeinAt(n, z)});
  // The artery is lateral of it.
  return column(Side::kRight, {Curve<5>(std::move(knots)), 2, 0.3, Form::kFaceted, 0}, seed);
}

/// Distance outside the space that the thrombus takes: the whole lumen, and a tail in the middle of the lumen.
double outsideThrombus_mm(const GroinParameters& n, Vec3 p) {
  const double x = -p.x;
  if (p.z < kThrombusFills_mm) return kThrombusEnd_mm - p.z;
  const auto vein = femoralVeinAt(n, p.z);
  const double t = (p.z - kThrombusFills_mm) / (kThrombusTail_mm - kThrombusFills_mm);
  const double radius = t < 1 ? 1.25 * vein[2] * std::sqrt(1 - t) : -1;
  return std::hypot(x - vein[0], p.y - vein[1]) - radius;
}

std::vector<Tube::Knot> partOfVein(const GroinParameters& n, double from_mm, double to_mm) {
  constexpr double kKnots_mm = 3;
  std::vector<Tube::Knot> line;
  for (double z = from_mm; z >= to_mm; z -= kKnots_mm) {
    const auto [x, y, halfWidth, halfHeight, turn] = femoralVeinAt(n, z);
    line.push_back({{patientX(Side::kRight, x), y, z}, (halfWidth + halfHeight) / 2});
  }
  return line;
}

std::vector<Tube::Knot> inPatient(std::vector<Tube::Knot> line) {
  for (Tube::Knot& knot : line) knot.p_mm.x = patientX(Side::kRight, knot.p_mm.x);
  return line;
}

/// A tributary is drawn from within the main vein; its named course begins at the wall of the main vein.
std::vector<Tube::Knot> tributary(const GroinParameters& n, const std::vector<Tube::Knot>& knots) {
  std::vector<Tube::Knot> line = centerLine(knots);
  std::erase_if(line, [&](const Tube::Knot& knot) {
    const auto vein = femoralVeinAt(n, knot.p_mm.z);
    return std::hypot((knot.p_mm.x - vein[0]) / vein[2], (knot.p_mm.y - vein[1]) / vein[3]) < 1.1;
  });
  return inPatient(std::move(line));
}

}  // namespace

double inguinalLigament_mm(double lateral_mm) {
  return 0.68 * lateral_mm;
}

std::array<double, 5> femoralVeinAt(const GroinParameters& n, double z_mm) {
  // Area 20 mm below the ligament: 90 mm2; measured 114 +- 35 mm2 in the frog-leg position and less in others
  // (Czyzewska et al., PLoS One 2017;12:e0182623, 205 adults). The artery covers none of the vein at the ligament, and
  // most of it in the thigh: 17 % at the ligament, 35 % 2 cm and 44 % 4 cm below it in the mean of 180 adults
  // (Beaudoin et al., CJEM 2011;13:245).
  static const Curve<5> kCourse{{kUpperEnd_mm, {-15, 35, 5.6, 5.2, 0}}, {14, {-13.6, 25, 5.8, 5, 0}},
                                {2, {-12.6, 16.5, 6, 4.8, 5}},          {-8, {-12, 12.8, 6, 4.8, 5}},
                                {-20, {-11.4, 11.6, 6.1, 4.9, 0}},      {-32, {-10.9, 12, 6.3, 5, 0}},
                                {-42, {-10.2, 13.2, 6.6, 5, 0}},        {-56, {-8.6, 16.4, 5.4, 4.6, 10}},
                                {-72, {-6.4, 20, 4.8, 4.2, 15}},        {kLowerEnd_mm, {-4.6, 23.5, 4.6, 4.1, 20}}};
  auto v = kCourse(z_mm);
  const double covered = n.overlap * overlapAt(z_mm);
  const auto [awayX, awayY] = tortuosity_mm(n.seed, z_mm, 0.5);
  v[0] += awayX + 2.2 * covered;
  v[1] += awayY + 4.2 * covered;
  v[2] *= n.veinScale;
  v[3] *= n.veinScale;
  return v;
}

void addGroinVessels(std::vector<Structure>& into, const GroinParameters& n, std::uint32_t seed) {
  std::vector<Shape> trunks, branches;
  for (Line& line : femoralArteries(n)) {
    const bool isTrunk = line.knots.front().radius_mm > 2;
    (isTrunk ? trunks : branches).push_back(tube(Side::kRight, {std::move(line.knots), 1, 0.15, 0.035}, seed++));
  }
  into.push_back({kArtery, Kind::kArtery, 1.0, join(std::move(trunks))});
  into.push_back({kArtery, Kind::kArtery, 0.45, join(std::move(branches))});
  const Shape vein = mainVein(n, seed);
  if (n.hasThrombus)
    into.push_back(
        {static_cast<Label>(kThrombus), Kind::kVein, 0, clip(vein, [n](Vec3 p) { return outsideThrombus_mm(n, p); })});
  into.push_back({kVein, Kind::kVein, 0.9, join({vein, tube(Side::kRight, {deepVein(n), 1, 0.15, 0.03}, seed + 1)})});
  into.push_back({kVein, Kind::kVein, 0.3, tube(Side::kRight, {saphenousVein(n), 1, 0.12, 0.05}, seed + 2)});
}

std::vector<VesselCourse> groinVessels(const GroinParameters& n) {
  const double ligament_mm = inguinalLigament_mm(femoralVeinAt(n, -8)[0]);
  // A thrombus is no part of a vessel.
  const double commonEnds_mm = n.hasThrombus ? kThrombusTail_mm : kDeepVein_mm;
  const double thighBegins_mm = n.hasThrombus ? kThrombusEnd_mm - 1 : kDeepVein_mm;
  std::vector<VesselCourse> all{{"right external iliac vein", kVein, partOfVein(n, kUpperEnd_mm, ligament_mm)},
                                {"right common femoral vein", kVein, partOfVein(n, ligament_mm, commonEnds_mm)},
                                {"right femoral vein", kVein, partOfVein(n, thighBegins_mm, kLowerEnd_mm)},
                                {"right great saphenous vein", kVein, tributary(n, saphenousVein(n))},
                                {"right deep femoral vein", kVein, tributary(n, deepVein(n))}};
  for (const Line& line : femoralArteries(n))
    all.push_back({"right " + std::string(line.name), kArtery, inPatient(centerLine(line.knots))});
  return all;
}

}  // namespace insonate::phantom
