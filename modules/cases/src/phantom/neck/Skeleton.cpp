#include "Anatomy.h"

#include <insonate/core/Hash.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace insonate::phantom {
namespace {

constexpr double kVertebra_mm = 17.5;    ///< height of a body and a disc
constexpr double kDiscShare = 0.26;      ///< share of the disc in this height
constexpr double kFirstDisc_mm = -61.5;  ///< lower edge of the lowest disc in the model

/// Position from the lower edge of a disc (0) to the next one (1).
double withinVertebra(double z_mm) {
  const double t = (z_mm - kFirstDisc_mm) / kVertebra_mm;
  return t - std::floor(t);
}

Curve<5> following(double lateral, double behindFront, double halfX, double halfY, double turn = 0) {
  std::vector<Curve<5>::Knot> knots;
  for (double z = -70; z <= 54; z += 4)
    knots.push_back({z, {lateral, vertebralFront_mm(z) + behindFront, halfX, halfY, turn}});
  return Curve<5>(std::move(knots));
}

/// Arches and processes of the vertebra whose body's middle is at z.
std::vector<Shape> processes(double z, std::uint32_t seed) {
  const double y = vertebralFront_mm(z);
  std::vector<Shape> parts;
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const auto bar = [&](std::vector<Tube::Knot> knots, double flatness) {
      parts.push_back(tube(side, {std::move(knots), flatness, 0.8}, seed++));
    };
    // Transverse process: two bars around the vertebral artery, ending in tubercles.
    bar({{{10, y + 8, z}, 2.6}, {{17, y + 7.5, z - 1}, 2.0}, {{24, y + 8, z - 3}, 2.6}}, 1.1);
    bar({{{11, y + 14, z}, 3.2}, {{19, y + 15.5, z - 1.5}, 2.6}, {{28, y + 15, z - 4}, 3.0}}, 1.0);
    bar({{{23, y + 8.5, z - 3}, 1.6}, {{26.5, y + 13.5, z - 4}, 1.7}}, 1.2);
    // Pedicle, lamina.
    bar({{{11, y + 15, z + 2}, 3.4}, {{17, y + 20, z + 1}, 4.0}}, 1.0);
    bar({{{17, y + 23, z - 1}, 3.6}, {{9, y + 31, z - 3}, 2.9}, {{0, y + 35, z - 5}, 2.8}}, 0.6);
  }
  // Spinous process, sloping to the foot, ending thick.
  parts.push_back(tube(Side::kRight,
                       {{{{0, y + 34, z - 4}, 2.6}, {{0.4, y + 41, z - 8}, 2.2}, {{0, y + 47, z - 11}, 3.4}}, 0.8, 0.5},
                       seed));
  return parts;
}

}  // namespace

double vertebralFront_mm(double z_mm) {
  static const Curve<1> kFront{{-70, {57}}, {-50, {49.5}}, {-40, {45}},  {-30, {41}},  {-20, {37.5}}, {-10, {34}},
                               {0, {31}},   {10, {28.5}},  {20, {26.5}}, {35, {23.5}}, {54, {21}}};
  return kFront(z_mm)[0];
}

void addSpine(std::vector<Structure>& into, std::uint32_t seed) {
  const Curve<5> canal = following(0, 24, 11.5, 7);
  into.push_back({kNerve, Kind::kOrgan, 0, column(Side::kRight, {following(0, 24, 6.5, 4.2), 3, 0.3}, seed++)});
  // Nerve roots leave the cord in the canal; its fluid and dura count as soft tissue.
  into.push_back({kSoftTissue, Kind::kOrgan, 0, column(Side::kRight, {canal, 3, 0.2}, seed++)});

  const auto disc = [](Vec3 p) { return (withinVertebra(p.z) - kDiscShare) * kVertebra_mm; };
  const auto body = [](Vec3 p) { return -(withinVertebra(p.z) - kDiscShare) * kVertebra_mm; };
  into.push_back(
      {kCartilage, Kind::kOrgan, 0, clip(column(Side::kRight, {following(0, 8.6, 13, 8.8), 3, 0.4}, seed++), disc)});
  std::vector<Shape> bones{clip(column(Side::kRight, {following(0, 8.5, 12.8, 8.3), 3, 0.5}, seed++), body)};
  for (const Side side : {Side::kRight, Side::kLeft})
    // Articular pillars, parted by the facet joints.
    bones.push_back(clip(column(side, {following(18.5, 21.5, 5.6, 6.2), 3, 0.9}, seed++), [](Vec3 p) {
      const double t = withinVertebra(p.z + 0.5 * (p.y - vertebralFront_mm(p.z) - 21.5) + 4);
      return 0.7 - std::min(t, 1 - t) * kVertebra_mm;
    }));
  for (double z = kFirstDisc_mm + kVertebra_mm * (0.5 + kDiscShare / 2) - kVertebra_mm; z < 66; z += kVertebra_mm) {
    std::vector<Shape> parts = processes(z, seed += 20);
    bones.insert(bones.end(), std::make_move_iterator(parts.begin()), std::make_move_iterator(parts.end()));
  }
  into.push_back({kBone, Kind::kOrgan, 0.7, join(std::move(bones))});
}

void addGirdle(std::vector<Structure>& into, const NeckParameters& n, std::uint32_t seed) {
  std::vector<Shape> bones;
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const double drop = side == Side::kRight ? 0 : 1.5;  // shoulders are never exactly level
    const auto add = [&](Tube t) {
      for (auto& knot : t.knots) knot.p_mm.z -= drop;
      bones.push_back(tube(side, std::move(t), seed++));
    };
    add({{{{14, 5, -53}, 7.5},
          {{22, 3.5, -50}, 6.6},
          {{34, 3, -47}, 5.6},
          {{48, 5.5, -44}, 5.4},
          {{62, 12, -41}, 5.4},
          {{80, 22, -38}, 5.8}},
         1.1,
         0.6});
    add({{{{24, 58, -17}, 3.6},
          {{38, 63, -18}, 3.8},
          {{50, 61, -23}, 3.8},
          {{60, 51, -32}, 4},
          {{62, 38, -43}, 4.2},
          {{54, 24, -53}, 4.2},
          {{40, 12, -61}, 4.2},
          {{24, 4, -70}, 4.5}},
         1.35,
         0.5});
    add({{{{27, 70, -34}, 3.6}, {{46, 78, -37}, 3.8}, {{62, 74, -45}, 4}, {{71, 60, -57}, 4}, {{72, 44, -70}, 4}},
         1.3,
         0.5});
    if (n.chest) std::ranges::copy(chestRibs(side, hash32(seed)), std::back_inserter(bones));
  }
  bones.push_back(column(Side::kRight,
                         {{{-80, {0, -6, 26, 6, 0}}, {-64, {0, -5, 24, 5.5, 0}}, {-52, {0, -2, 17, 4.5, 0}}}, 5, 0.6},
                         seed++));
  into.push_back({kBone, Kind::kOrgan, 0.6, join(std::move(bones))});
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const double top = side == Side::kRight ? -36 : -38;
    const Column apex{{{-110, {42, 54, 30, 30, 0}}, {-64, {38, 48, 25, 26, 0}}, {top, {32, 43, 16, 16, 0}}}, 26, 0.4};
    const Column lung = n.chest ? chestLung() : apex;
    into.push_back({kAirway, Kind::kOrgan, 1.0, column(side, lung, seed)});
    // Intercostal muscles close the chest wall between the ribs.
    into.push_back({kMuscle, Kind::kOrgan, 0, clip(shell(column(side, lung, seed++), 1.2, 3), [side](Vec3 p) {
                      return std::max(22 - patientX(side, p.x), p.z + 42);
                    })});
  }
}

}  // namespace insonate::phantom
