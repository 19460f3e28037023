#include "Anatomy.h"
#include "phantom/Individual.h"
#include "phantom/Variation.h"

#include <insonate/core/Hash.h>

#include <cmath>

namespace insonate::phantom {
namespace {

constexpr double kFlat = 0.1;  ///< nerves are slightly flat

/// Branches of the cervical plexus, in the fat behind and around the sternocleidomastoid; number and places vary
/// between people.
void addBranches(std::vector<Shape>& nerves, Side side, std::uint32_t seed) {
  const Individual count(seed + 40);
  const int branches = 4 + static_cast<int>(2.5 * (1 + count(0)));
  for (int n = 0; n < branches; ++n) {
    const Individual vary(seed + 41 + n);
    const double z = 14 + 16 * vary(1), drop = 24 + 10 * vary(2), radius = 0.75 + 0.2 * vary(3);
    const double x = 42 + 5 * vary(4), y = 31 + 7 * vary(5), out = 8 + 6 * vary(6), back = 4 * vary(7);
    nerves.push_back(tube(side,
                          {{{{x, y, z}, radius},
                            {{x + 0.4 * out + vary(8), y + 0.3 * back + vary(9), z - 0.4 * drop}, radius},
                            {{x + out, y + back, z - drop}, 0.8 * radius}},
                           1,
                           0.1,
                           kFlat},
                          seed + 41 + n));
  }
}

void addNerves(std::vector<Structure>& into, Side side, std::uint32_t seed) {
  // Vagus, in the groove behind carotid and jugular; sympathetic trunk; phrenic nerve on the scalenus anterior.
  std::vector<Shape> nerves{
      tube(side,
           {{{{19, 30, -60}, 1.2},
             {{24.5, 28.5, -35}, 1.2},
             {{27.2, 28.3, -15}, 1.25},
             {{27, 28.6, 0}, 1.25},
             {{28, 28, 15}, 1.25},
             {{30.5, 27.5, 32}, 1.3},
             {{31, 29.5, 56}, 1.4}},
            1,
            0.1,
            kFlat},
           seed++),
      tube(side,
           {{{{22, 38, -50}, 0.9}, {{20.5, 32.8, -20}, 0.9}, {{19.5, 29.5, 10}, 1.0}, {{21, 25.5, 40}, 1.2}},
            1,
            0,
            kFlat},
           seed++)};
  // Brachial plexus: roots from the grooves of the transverse processes, between scalenus anterior and medius.
  struct Root {
    double z, lateralEnd, yEnd, zEnd;
  };
  for (const Root& r : {Root{19, 56, 33, -32}, Root{2, 57, 35, -35}, Root{-15, 58, 37, -38}, Root{-32, 56, 38, -42}}) {
    const double y = vertebralFront_mm(r.z) + 12;
    const double mid = 0.5 * r.z + 0.5 * r.zEnd + 3;
    nerves.push_back(tube(side,
                          {{{{21, y, r.z}, 1.6},
                            {{29, y - 1.5, r.z - 4}, 1.8},
                            {{42, 0.5 * (y + r.yEnd) - 1, mid}, 1.7},
                            {{r.lateralEnd, r.yEnd, r.zEnd}, 1.6},
                            {{r.lateralEnd + 24, r.yEnd - 3, r.zEnd - 14}, 1.7}},
                           1,
                           0.15,
                           kFlat},
                          seed++));
  }
  addBranches(nerves, side, seed);
  into.push_back({kNerve, Kind::kOrgan, 0.5, join(std::move(nerves))});
}

/// Nodes along the jugular chain, in the posterior triangle and under the chin: oval, long axis upright.
void addNodes(std::vector<Structure>& into, Side side, std::uint32_t seed) {
  struct Node {
    double lateral, y, z, halfX, halfY, halfZ, turn;
  };
  constexpr Node kNodes[] = {
      {42.5, 25.5, 28, 2.6, 1.9, 5, 30}, {44, 31, 8, 2.8, 1.8, 4.5, 50}, {41.5, 28.5, -10, 2.4, 1.7, 4, 20},
      {43, 20.5, -27, 2.6, 1.9, 4, 60},  {50, 41, -4, 3, 2, 4, 70},      {52, 46, 14, 2.5, 1.8, 3.5, 70},
      {47, 29, -16, 2.2, 1.6, 3, 40},    {30, 13, 33, 3.2, 2.2, 5, 30},  {12, 12, -38, 2.0, 1.6, 3, 0}};
  constexpr double kSeen = 0.75;  ///< share of the nodes that one person has
  std::vector<Shape> nodes;
  for (const Node& d : kNodes) {
    const Individual vary(++seed);
    // Everybody has the first two.
    if (nodes.size() > 1 && vary(0) > 2 * kSeen - 1) continue;
    const double s = 1 + 0.25 * vary(1), h = d.halfZ * s * (1.1 + 0.25 * vary(2)), z = d.z + 2.5 * vary(3);
    const std::array<double, 5> v{d.lateral + 1.5 * vary(4), d.y + vary(5), d.halfX * s * (1.1 + 0.2 * vary(6)),
                                  d.halfY * s, d.turn + 20 * vary(7)};
    nodes.push_back(column(side, {{{z - h, v}, {z + h, v}}, h, 0.35}, seed));
  }
  into.push_back({kLymphNode, Kind::kOrgan, 0.5, join(std::move(nodes))});
}

}  // namespace

void addNervesAndGlands(std::vector<Structure>& into, const NeckParameters& n, std::uint32_t seed) {
  std::vector<Shape> thyroid;
  const double s = n.thyroidScale;
  for (const Side side : {Side::kRight, Side::kLeft}) {
    addNerves(into, side, seed += 20);
    addNodes(into, side, seed += 20);
    const double k = s * (side == Side::kRight ? 1.05 : 0.96);
    // Both poles are pointed; length and height of the lobes vary between people.
    const Individual vary(seed);
    const double l = 1 + 0.14 * vary(1);
    const auto at = [&](double z, double lateral, double y, double halfX, double halfY, double turn) {
      return Curve<5>::Knot{-16 + (z + 16) * l + 3 * vary(2), {lateral, y, halfX * k, halfY * k, turn}};
    };
    thyroid.push_back(
        column(side,
               varied({{at(-42, 14.5, 23.5, 1.2, 1.6, 0), at(-37, 14.5, 23, 3.8, 4.6, 0),
                        at(-30, 15.5, 22, 6.4, 7.8, 10), at(-19, 16, 19.5, 8, 9.5, 12), at(-8, 16, 17, 7, 9, 14),
                        at(2, 18, 15.5, 4.2, 7, 14), at(11, 17.5, 14.5, 2.2, 4, 14), at(17, 17, 13.5, 1, 1.6, 14)},
                       3,
                       0.5},
                      seed),
               seed));
    ++seed;
    into.push_back(
        {kGland, Kind::kOrgan, 0.6,
         column(side, {{{28, {32, 2, 9, 7, 30}}, {40, {32, -1, 13, 9, 35}}, {58, {32, -4, 13, 9, 35}}}, 9, 0.8},
                seed++)});
  }
  thyroid.push_back(tube(
      Side::kRight,
      {{{{-12, 13, -18}, 2.4}, {{-6, 8.8, -17}, 2.0}, {{0, 7.2, -17}, 1.9}, {{6, 8.6, -17}, 2.0}, {{12, 13, -18}, 2.4}},
       0.36,
       0.3},
      seed++));
  into.push_back({kThyroid, Kind::kOrgan, 0.6, join(std::move(thyroid))});
}

}  // namespace insonate::phantom
