#include "Arm.h"
#include "phantom/Variation.h"

namespace insonate::phantom {
namespace {

constexpr double kArmTop_mm = 52, kArmBottom_mm = -52;

/// Deviation from the straight course that artery, brachial veins and median nerve share.
Vec3 bundle_mm(const ArmParameters& n, double z) {
  const auto [x, y] = tortuosity_mm(n.seed + 1, z, 0.5);
  return {x, y, z};
}

struct ArmVessel {
  std::string_view name;
  Label label;
  std::vector<Tube::Knot> knots;
  double sheath_mm;
};

constexpr double kLevels_mm[]{kArmTop_mm, 35, 18, 0, -18, -35, kArmBottom_mm};

/// Cord beside the brachial artery; `x_mm` and `y_mm`: from the artery's center at the top and at the bottom.
std::vector<Tube::Knot> besideArtery(const ArmParameters& n, const std::array<double, 2>& x_mm,
                                     const std::array<double, 2>& y_mm, double radius_mm) {
  constexpr double kArteryX_mm = 3, kArteryY_mm = 15;
  std::vector<Tube::Knot> knots;
  for (const double z : kLevels_mm) {
    const double t = (kArmTop_mm - z) / (kArmTop_mm - kArmBottom_mm);
    const Vec3 bundle = bundle_mm(n, z);
    knots.push_back({{kArteryX_mm + bundle.x + x_mm[0] + (x_mm[1] - x_mm[0]) * t,
                      kArteryY_mm + bundle.y + y_mm[0] + (y_mm[1] - y_mm[0]) * t, z},
                     radius_mm});
  }
  return knots;
}

/// Artery of 4.4 mm with a vein of 2.6 to 3 mm on each side. Basilic vein: 4 to 6 mm wide and mostly the widest vein of
/// the arm (Sharp et al., J Infus Nurs 2015;38:351, 176 persons); here 4.6 mm, with its front wall 8 to 9 mm below the
/// skin. It passes through the fascia in the lower half of the arm.
std::vector<ArmVessel> vessels(const ArmParameters& n) {
  const double s = n.veinScale;
  return {{"brachial artery", kArtery, besideArtery(n, {0, 0}, {0, 0}, 2.2), 0.6},
          {"anterior brachial vein", kVein, besideArtery(n, {3.9, 4}, {-2.6, -2.6}, 1.5 * s), 0.3},
          {"posterior brachial vein", kVein, besideArtery(n, {-3.9, -3.8}, {-2.4, -2.3}, 1.35 * s), 0.3},
          {"basilic vein", kVein, basilicVein(n), 0.3},
          {"cephalic vein",
           kVein,
           {{{31, 65.5, kArmTop_mm}, 1.4 * s},
            {{30.6, 67, 10}, 1.5 * s},
            {{28, 69.5, -25}, 1.5 * s},
            {{25.5, 71.5, kArmBottom_mm}, 1.5 * s}},
           0.25},
          {"deep brachial artery",
           kArtery,
           {{{-4, 20, kArmTop_mm}, 1.3},
            {{-9, 29, 35}, 1.3},
            {{-11, 41, 16}, 1.2},
            {{-10, 53, 0}, 1.1},
            {{2, 59, -20}, 1},
            {{14, 60, -44}, 0.9}},
           0.4}};
}

}  // namespace

std::vector<Tube::Knot> basilicVein(const ArmParameters& n) {
  std::vector<Tube::Knot> knots;
  const std::array<std::array<double, 2>, 7> at{
      {{-6.5, 8.6}, {-7.6, 7.6}, {-8.4, 6.8}, {-8.8, 6.2}, {-8.6, 5.2}, {-8.2, 3.6}, {-7.4, 1.8}}};
  for (std::size_t k = 0; k < at.size(); ++k) {
    const double z = kLevels_mm[k];
    const auto [x, y] = tortuosity_mm(n.seed + 2, z, 0.4);
    knots.push_back({{at[k][0] + x, at[k][1] + 0.6 * y, z}, 2.3 * n.veinScale});
  }
  return knots;
}

void addArmVessels(std::vector<Structure>& into, const ArmParameters& n, std::uint32_t seed) {
  for (ArmVessel& one : vessels(n)) {
    const bool isVein = one.label == kVein;
    into.push_back({one.label, isVein ? Kind::kVein : Kind::kArtery, one.sheath_mm,
                    tube(Side::kRight, {std::move(one.knots), 1, isVein ? 0.12 : 0.08, isVein ? 0.07 : 0.03}, seed++)});
  }
}

std::vector<VesselCourse> armVessels(const ArmParameters& n) {
  std::vector<VesselCourse> all;
  for (const ArmVessel& one : vessels(n)) {
    VesselCourse course{"right " + std::string(one.name), one.label, centerLine(one.knots)};
    for (Tube::Knot& knot : course.line) knot.p_mm.x = patientX(Side::kRight, knot.p_mm.x);
    all.push_back(std::move(course));
  }
  return all;
}

void addArmNerves(std::vector<Structure>& into, const ArmParameters& n, std::uint32_t seed) {
  const auto nerve = [&](std::vector<Tube::Knot> knots, double sheath_mm) {
    into.push_back({kNerve, Kind::kOrgan, sheath_mm, tube(Side::kRight, {std::move(knots), 1, 0.1, 0.12}, seed++)});
  };
  // The median nerve runs on the biceps' side of the artery and crosses in front of it toward the elbow; the ulnar
  // nerve leaves the artery toward the back. The cutaneous nerve of the forearm accompanies the basilic vein.
  nerve(besideArtery(n, {8.4, 3}, {-0.6, -6.4}, 1.9), 0.45);
  nerve({{{-5, 14.6, kArmTop_mm}, 1.6},
         {{-7.6, 15, 25}, 1.6},
         {{-11.4, 15.6, 0}, 1.6},
         {{-16, 16.6, -25}, 1.5},
         {{-20, 18, kArmBottom_mm}, 1.5}},
        0.4);
  nerve({{{-2.6, 6.6, kArmTop_mm}, 0.9},
         {{-3.8, 4.6, 20}, 0.9},
         {{-4.6, 3.2, 0}, 0.85},
         {{-4, 1, -25}, 0.8},
         {{-3, -0.6, kArmBottom_mm}, 0.7}},
        0.3);
  nerve({{{-8, 30, 40}, 1.6},
         {{-13, 44, 16}, 1.5},
         {{-8, 57, -4}, 1.5},
         {{8, 62, -28}, 1.4},
         {{16, 61, kArmBottom_mm}, 1.4}},
        0.4);
  nerve({{{12, 22, kArmTop_mm}, 1.1}, {{16, 34, 10}, 1.1}, {{20, 44, -20}, 1}, {{24, 50, kArmBottom_mm}, 1}}, 0.3);
}

void addArmMusclesAndBone(std::vector<Structure>& into, std::uint32_t seed) {
  into.push_back({kBone, Kind::kOrgan, 0.4,
                  column(Side::kRight,
                         {{{-90, {4, 46, 11, 10, 0}},
                           {-30, {3.4, 46, 10.4, 10, 0}},
                           {30, {3, 45, 10.6, 10.6, 0}},
                           {90, {3, 44, 12, 12, 0}}},
                          3,
                          0.3},
                         seed++)});
  const auto add = [&](Column belly) {
    ++seed;
    belly.form = Form::kBelly;
    into.push_back({kMuscle, Kind::kMuscle, 0, column(Side::kRight, varied(std::move(belly), seed), seed)});
  };
  // Biceps, brachialis, coracobrachialis.
  add({{{120, {18, 24, 10, 11, 0}},
        {40, {21, 26, 13, 16, -20}},
        {0, {22, 27, 14, 18.5, -25}},
        {-40, {21, 26, 14, 17.5, -25}},
        {-120, {16, 22, 8, 8, 0}}},
       4,
       0.5});
  add({{{42, {20, 54, 5, 8, 0}},
        {10, {19, 55, 13, 14, -20}},
        {-25, {18, 54, 17, 15, -15}},
        {-120, {14, 48, 18, 14, 0}}},
       4,
       0.5});
  add({{{120, {8, 26, 7, 8, 0}}, {44, {7, 29, 6.5, 8, 0}}, {0, {5, 33, 4, 5, 0}}}, 4, 0.4});
  // Triceps: long, medial and lateral head.
  add({{{120, {-16, 24, 12, 13, 0}},
        {30, {-20, 29, 14.5, 17, 20}},
        {-20, {-22, 34, 13.5, 18, 15}},
        {-120, {-20, 46, 9, 14, 0}}},
       4,
       0.5});
  add({{{44, {-9, 44, 7, 8, 0}}, {5, {-8, 34, 10, 11, 30}}, {-25, {-7, 33, 12, 11, 20}}, {-120, {-6, 36, 13, 10, 0}}},
       4,
       0.5});
  add({{{120, {-8, 64, 14, 9, 0}},
        {20, {-12, 61, 18, 14, 20}},
        {-30, {-12, 60, 18, 13, 20}},
        {-120, {-8, 60, 12, 8, 0}}},
       4,
       0.5});
  // Deltoid, above its insertion.
  add({{{120, {14, 66, 24, 12, -10}}, {50, {14, 68, 14, 7, -10}}, {14, {12, 64, 3, 3, 0}}}, 4, 0.5});
}

}  // namespace insonate::phantom
