#include "Anatomy.h"
#include "phantom/Variation.h"

#include <utility>

namespace insonate::phantom {
namespace {

/// Adds the muscles of one side, each with its own variation.
class Muscles {
 public:
  Muscles(std::vector<Structure>& into, Side side, std::uint32_t seed) : into_(into), side_(side), seed_(seed) {}

  void operator()(Sheet flat) { add(sheet(side_, varied(std::move(flat), seed_), seed_)); }
  void operator()(Column belly) {
    if (belly.form == Form::kOval) belly.form = Form::kBelly;
    add(column(side_, varied(std::move(belly), seed_), seed_));
  }
  void operator()(Tube cord) {
    cord.oval = 0.12;
    add(tube(side_, std::move(cord), seed_));
  }

 private:
  void add(Shape shape) {
    into_.push_back({kMuscle, Kind::kMuscle, 0, std::move(shape)});
    ++seed_;
  }

  std::vector<Structure>& into_;
  Side side_;
  std::uint32_t seed_;
};

void addSternocleidomastoid(std::vector<Structure>& into, const NeckParameters& n, Side side, std::uint32_t seed) {
  const double t = n.sternomastoidScale, below = 0.8;
  // Belly and heads are one muscle and vary together.
  const auto part = [&](Sheet usual, std::uint32_t own) { return sheet(side, varied(std::move(usual), seed), own); };
  const auto at = [&](double z, double angle, double halfWidth, double halfThickness) {
    return Curve<4>::Knot{z, {angle, halfThickness * t + below, halfWidth, halfThickness * t}};
  };
  const Shape belly = part({{at(-16, 44, 11, 3), at(-5, 48, 17, 4.6), at(6, 53, 18, 5.1), at(20, 59, 17.5, 5.6),
                             at(38, 68, 16, 6), at(58, 80, 15, 6)},
                            5,
                            0.6},
                           seed);
  // Two heads, with a gap above the clavicle.
  const Shape sternal = part({{at(-60, 9, 4, 2.2), at(-46, 11.5, 5.8, 2.6), at(-34, 18, 7.5, 3), at(-20, 28, 10, 3.8),
                               at(-6, 39, 12, 4.4), at(6, 46, 10, 4.4)},
                              6,
                              0.5},
                             seed + 1);
  const Shape clavicular = part(
      {{at(-44, 50, 13, 2.3), at(-34, 51, 12.5, 2.7), at(-20, 54, 11.5, 3.2), at(-6, 56, 11, 4), at(8, 60, 9, 4.2)},
       6,
       0.5},
      seed + 2);
  into.push_back({kSternocleidomastoid, Kind::kMuscle, 0, join({belly, sternal, clavicular})});
}

void addInfrahyoid(std::vector<Structure>& into, Side side, std::uint32_t seed) {
  Muscles add(into, side, seed);
  // Sternohyoid, sternothyroid, thyrohyoid, omohyoid.
  add(Sheet{{{-62, {13, 9.5, 8, 2}},
             {-40, {12, 8, 8.4, 2.1}},
             {-28, {11.5, 5.6, 8.6, 2.2}},
             {-15, {10.5, 3.4, 8.6, 2.1}},
             {5, {10, 2.8, 8, 2}},
             {20, {11, 2.6, 7, 1.9}},
             {34, {8, 4, 6, 1.9}}},
            3,
            0.35});
  add(Sheet{{{-62, {12, 14, 8, 1.7}},
             {-40, {14, 12.5, 10, 1.9}},
             {-28, {16, 9.8, 10.5, 1.9}},
             {-15, {17, 7.8, 10.5, 1.9}},
             {0, {20, 7.2, 8.5, 1.8}},
             {12, {21, 6.4, 6, 1.4}}},
            3,
            0.35});
  add(Sheet{{{8, {20, 5.8, 5.5, 1.5}}, {20, {18, 5.2, 7, 1.9}}, {34, {17, 6.4, 6.5, 1.8}}}, 2, 0.3});
  // Its upper belly is flat; its tendon passes in front of the jugular vein.
  add(Column{{{36, {13, -8, 4.4, 2.3, 40}},
              {22, {19, -2.5, 5, 2.4, 44}},
              {8, {24.5, 5, 5.2, 2.3, 48}},
              {-5, {29.5, 11.3, 4.4, 1.9, 50}},
              {-17, {37.5, 14.5, 3, 1.4, 45}}},
             3,
             0.3,
             Form::kLens});
  add(Tube{{{{35, 13.6, -13}, 1.5}, {{48, 21, -24}, 2.4}, {{62, 35, -31}, 2.8}, {{82, 50, -36}, 3}}, 1.3, 0.35});
}

void addPrevertebral(std::vector<Structure>& into, Side side, std::uint32_t seed) {
  const auto front = [](double z, double behind) { return vertebralFront_mm(z) + behind; };
  Muscles add(into, side, seed);
  // Longus colli and capitis; scalenus anterior, medius, posterior; levator scapulae.
  add(Column{{{-60, {8, front(-60, -2.2), 5, 2.6, 0}},
              {-30, {9, front(-30, -2.4), 6.5, 3, 0}},
              {0, {9, front(0, -1.8), 7, 3.2, 0}},
              {30, {7.5, front(30, -2.2), 6, 3, 0}},
              {56, {6, front(56, -2), 5, 2.6, 0}}},
             4,
             0.4,
             Form::kLens});
  add(Column{{{-6, {18.5, front(-6, 3.8), 4, 3, 20}},
              {12, {18, front(12, 2.6), 5.5, 3.6, 20}},
              {34, {15.5, front(34, 0.8), 6, 4, 10}},
              {56, {14, front(56, 0), 6.5, 4.2, 10}}},
             4,
             0.4});
  add(Column{{{-50, {46, 25, 6, 4.4, 10}},
              {-38, {43, 27.5, 7, 4.6, 15}},
              {-25, {38.5, 31, 7, 4.8, 20}},
              {-10, {33, 34.5, 6.6, 4.8, 25}},
              {5, {29, 35, 5.5, 4.4, 25}},
              {24, {26.5, 32.5, 3.6, 3.2, 20}}},
             4,
             0.5});
  add(Column{{{-44, {55, 42, 9, 6.5, 10}},
              {-28, {49.5, 44, 8.6, 7.5, 15}},
              {-12, {42.5, 46, 7.6, 7.8, 20}},
              {4, {36.5, 45, 6.6, 7, 20}},
              {20, {32.5, 42.5, 5.2, 5.6, 20}},
              {40, {30, 39, 3.6, 4, 20}}},
             4,
             0.6});
  add(Column{{{-44, {60, 55, 6, 7, 0}},
              {-24, {51, 57, 5.5, 7, 10}},
              {-4, {42, 56.5, 4.8, 5.8, 10}},
              {10, {37, 53.5, 3, 4, 0}}},
             4,
             0.5});
  add(Column{{{-50, {58, 88, 8, 12, -15}},
              {-25, {50, 77, 8, 12, -15}},
              {0, {44.5, 65.5, 7, 11.5, -15}},
              {20, {41, 58, 6.2, 11, -10}},
              {40, {37.5, 53, 5.6, 9, -5}},
              {58, {35, 50, 5, 7, 0}}},
             4,
             0.6});
}

void addNape(std::vector<Structure>& into, Side side, std::uint32_t seed) {
  Muscles add(into, side, seed);
  const auto paraspinal = [&](double lateral, double behind, double halfX, double halfY, double turn) {
    std::vector<Curve<5>::Knot> knots;
    for (double z = -70; z <= 62; z += 12)
      knots.push_back({z, {lateral, vertebralFront_mm(z) + behind, halfX, halfY, turn}});
    add(Column{Curve<5>(std::move(knots)), 4, 0.7});
  };
  // Trapezius, splenius, rhomboid and serratus posterior, then the paraspinal muscles from multifidus outward.
  add(Sheet{{{-70, {125, 7.5, 90, 6}},
             {-45, {127, 6.8, 72, 5.6}},
             {-20, {136, 5.4, 52, 4.4}},
             {0, {145, 4.2, 38, 3.2}},
             {20, {154, 3, 27, 2.2}},
             {44, {162, 2.4, 19, 1.6}},
             {60, {165, 2.2, 15, 1.4}}},
            4,
            0.5});
  add(Sheet{{{-50, {152, 16, 20, 3}},
             {-20, {148, 13, 20, 3.2}},
             {0, {143, 11, 21, 3.4}},
             {20, {136, 8, 22, 3.6}},
             {44, {126, 6.5, 21, 3.8}},
             {60, {118, 6, 20, 4}}},
            4,
            0.6});
  add(Sheet{{{-72, {138, 20, 60, 4.5}}, {-45, {140, 18, 50, 4}}, {-30, {145, 17, 30, 3}}}, 4, 0.6});
  paraspinal(8.5, 37.5, 7, 6.5, 0);
  paraspinal(12, 50, 10.5, 7.5, -12);
  paraspinal(24.5, 34.5, 7, 7.5, -20);
  paraspinal(31, 41, 6, 7, -30);
  // Supraspinatus; serratus anterior; iliocostal and longissimus of the chest.
  add(Column{{{-80, {68, 82, 18, 13, 0}}, {-34, {68, 76, 10, 9, 0}}}, 10, 0.8});
  add(Column{{{-80, {78, 50, 8, 16, 0}}, {-38, {73, 46, 6, 10, 0}}}, 8, 0.8});
  add(Column{{{-80, {36, 86, 10, 9, 10}}, {-26, {34, 72, 6, 6, 10}}}, 8, 0.8});
}

void addFloorOfMouthAndChest(std::vector<Structure>& into, Side side, std::uint32_t seed) {
  Muscles add(into, side, seed);
  // Digastric with stylohyoid, mylohyoid; pectoralis major.
  add(Sheet{{{37, {9, 4, 6, 2.6}}, {44, {9, 5, 7, 3.4}}, {60, {8, 6, 7, 3.6}}}, 3, 0.4});
  add(Tube{{{{15, -4, 40}, 2}, {{24, 6, 41}, 2.4}, {{34, 16, 47}, 3.4}, {{41, 26, 58}, 3.8}}, 1, 0.3});
  add(Column{{{36, {6, -6, 6, 6, 0}}, {44, {8, -12, 9, 10, 0}}, {60, {9, -18, 10, 14, 0}}}, 4, 0.6});
  add(Sheet{{{-80, {48, 6.5, 44, 5.5}}, {-60, {46, 5.5, 34, 4}}, {-52, {44, 4.4, 24, 2.5}}}, 6, 0.5});
}

}  // namespace

void addMuscles(std::vector<Structure>& into, const NeckParameters& n, std::uint32_t seed) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    addSternocleidomastoid(into, n, side, seed += 30);
    addInfrahyoid(into, side, seed += 30);
    addPrevertebral(into, side, seed += 30);
    addNape(into, side, seed += 30);
    addFloorOfMouthAndChest(into, side, seed += 30);
  }
}

}  // namespace insonate::phantom
