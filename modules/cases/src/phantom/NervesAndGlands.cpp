#include "Anatomy.h"

#include <insonate/core/Hash.h>

#include <cmath>

namespace insonate::phantom {
namespace {

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
            0.1},
           seed++),
      tube(side,
           {{{{22, 38, -50}, 0.9}, {{20.5, 32.8, -20}, 0.9}, {{19.5, 29.5, 10}, 1.0}, {{21, 25.5, 40}, 1.2}}, 1, 0},
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
                           0.15},
                          seed++));
  }
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
  std::vector<Shape> nodes;
  for (const Node& d : kNodes) {
    const double s = (0.8 + 0.4 * unitInterval(hash32(seed))), h = d.halfZ * s;
    const double dx = 2 * unitInterval(hash32(seed + 77)) - 1;
    const std::array<double, 5> v{d.lateral + dx, d.y, d.halfX * s, d.halfY * s, d.turn};
    nodes.push_back(column(side, {{{d.z - h, v}, {d.z + h, v}}, h, 0.35}, seed++));
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
    thyroid.push_back(column(side,
                             {{{-39, {14, 23, 4 * k, 5 * k, 0}},
                               {-30, {15.5, 22, 6.6 * k, 8 * k, 10}},
                               {-19, {16, 19.5, 8 * k, 9.5 * k, 12}},
                               {-8, {16, 17, 7 * k, 9 * k, 14}},
                               {2, {18, 15.5, 4.2 * k, 7 * k, 14}},
                               {11, {17.5, 14.5, 2.6 * k, 4.5 * k, 14}}},
                              4,
                              0.5},
                             seed++));
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
