#include "Anatomy.h"

namespace insonate::phantom {

std::vector<Tube::Knot> axillaryVein() {
  return {{{25, 14, -53}, 5},   {{38, 15, -53}, 5.2}, {{52, 14.5, -55}, 5.4}, {{66, 14, -59}, 5.8},
          {{75, 14, -62.5}, 6}, {{90, 18, -70}, 5.4}, {{108, 26, -80}, 4.8},  {{130, 36, -96}, 4.5}};
}

std::vector<Tube::Knot> axillaryArtery() {
  return {{{46, 32, -39}, 4}, {{60, 26, -46}, 3.8}, {{75, 22, -53}, 3.6}, {{92, 25, -60}, 3.5}, {{128, 38, -78}, 3.4}};
}

std::vector<Shape> chestRibs(Side side, std::uint32_t seed) {
  return {
      tube(side,
           {{{{72, 44, -70}, 4}, {{70, 28, -77}, 4.2}, {{60, 16, -84}, 4.4}, {{44, 8, -89}, 4.4}, {{22, -2, -92}, 4.6}},
            1.35,
            0.5},
           seed),
      tube(side, {{{{88, 62, -82}, 4}, {{89, 44, -92}, 4.2}, {{82, 26, -100}, 4.4}, {{62, 12, -107}, 4.4}}, 1.35, 0.5},
           seed + 1)};
}

Column chestLung() {
  return {{{-110, {50, 56, 44, 40, 0}},
           {-85, {46.5, 53.5, 37, 33.5, 0}},
           {-64, {40, 51, 27, 26.5, 0}},
           {-36, {32, 43, 16, 16, 0}}},
          26,
          0.4};
}

void addChestMuscles(std::vector<Structure>& into, std::uint32_t seed) {
  const auto add = [&](Shape shape) { into.push_back({kMuscle, Kind::kMuscle, 0, std::move(shape)}); };
  for (const Side side : {Side::kRight, Side::kLeft}) {
    // Pectoralis major toward the arm, pectoralis minor below it from the coracoid to the third rib, subclavius.
    add(sheet(side, {{{-110, {66, 6.5, 50, 5.5}}, {-80, {70, 6.2, 44, 5}}, {-62, {74, 5.6, 30, 4}}}, 6, 0.5}, seed++));
    add(sheet(
        side,
        {{{-110, {58, 16.5, 16, 2.6}}, {-90, {66, 15.5, 14, 2.8}}, {-72, {75, 15, 12, 2.8}}, {-56, {84, 15.5, 8, 2.4}}},
         5,
         0.4},
        seed++));
    add(tube(side, {{{{34, 8, -56}, 2.2}, {{50, 9.5, -51.5}, 2.8}, {{70, 16, -46}, 2.4}}, 1, 0.3}, seed++));
  }
}

}  // namespace insonate::phantom
