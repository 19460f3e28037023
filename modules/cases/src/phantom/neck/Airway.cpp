#include "Anatomy.h"

#include <cmath>

namespace insonate::phantom {
namespace {

Shape lumen() {
  const auto y = [](double z) { return airwayCenter_mm(z); };
  return column(Side::kRight,
                {{{-80, {0, y(-80), 8.2, 7.6, 0}},
                  {-40, {0, y(-40), 8.2, 7.8, 0}},
                  {-14, {0, y(-14), 8, 8, 0}},
                  {-3, {0, y(-3), 7.4, 8.6, 0}},
                  {4, {0, y(4), 4.8, 9, 0}},
                  {9, {0, y(9), 2, 9.2, 0}},
                  {13, {0, y(13), 4.5, 8, 0}},
                  {22, {0, y(22), 7, 6.5, 0}},
                  {32, {0, 9, 11, 4.5, 0}},
                  {54, {0, 9, 13, 5, 0}}},
                 2,
                 0.25},
                0x41aU);
}

/// Tracheal rings: C-shaped, open toward the esophagus, with slightly different heights.
double ringLimit_mm(Vec3 p) {
  constexpr double kPitch_mm = 4.4, kHalf_mm = 1.5;
  const double t = (p.z + 0.5 * std::sin(p.x / 6)) / kPitch_mm;
  const double alongAxis = std::abs(t - std::round(t)) * kPitch_mm - kHalf_mm;
  const double back = p.y - (airwayCenter_mm(p.z) + 4.5);
  return std::max({alongAxis, back, p.z + 12.5});
}

/// Cricoid: a signet ring, low arch in front, tall plate behind.
double cricoidLimit_mm(Vec3 p) {
  const double back = std::clamp((p.y - airwayCenter_mm(p.z) + 8) / 16, 0.0, 1.0);
  const double top = -3 + 13 * back * back, bottom = -9.5 + back;
  return std::max(p.z - top, bottom - p.z);
}

void addThyroidCartilage(std::vector<Structure>& into, std::uint32_t seed) {
  std::vector<Shape> plates;
  for (const Side side : {Side::kRight, Side::kLeft}) {
    plates.push_back(column(side,
                            {{{2, {9, 8.5, 12, 1.3, 57}},
                              {8, {8.6, 7, 14.5, 1.4, 57}},
                              {16, {9, 5.5, 16.5, 1.5, 58}},
                              {22, {10, 6.5, 15.5, 1.5, 60}},
                              {28, {13.5, 11.5, 9.5, 1.4, 62}}},
                             1.5,
                             0.3},
                            seed++));
    // Upper and lower horns.
    plates.push_back(
        tube(side, {{{{17.5, 19.5, 20}, 1.9}, {{18.5, 20, 28}, 1.7}, {{19.5, 18, 34}, 1.4}}, 1, 0.1}, seed++));
    plates.push_back(tube(side, {{{{14.8, 19, 6}, 1.6}, {{12.2, 18.5, -2}, 1.3}}, 1, 0.1}, seed++));
    plates.push_back(tube(side, {{{{5, 17.5, 10}, 2.6}, {{3, 16.5, 15}, 1.6}}, 1, 0.1}, seed++));  // arytenoid
  }
  into.push_back({kCartilage, Kind::kOrgan, 0.6, join(std::move(plates))});
}

}  // namespace

double airwayCenter_mm(double z_mm) {
  static const Curve<1> kCenter{{-80, {40}},   {-64, {34.5}}, {-50, {29.5}}, {-40, {26}}, {-30, {22.5}}, {-20, {19}},
                                {-10, {15.5}}, {0, {12.5}},   {10, {9.5}},   {20, {8.5}}, {34, {9}}};
  return kCenter(z_mm)[0];
}

void addAirway(std::vector<Structure>& into, std::uint32_t seed) {
  into.push_back({kAirway, Kind::kOrgan, 0, lumen()});
  into.push_back({kCartilage, Kind::kOrgan, 0, clip(shell(lumen(), 0.7, 2.3), ringLimit_mm)});
  into.push_back({kCartilage, Kind::kOrgan, 0.5, clip(shell(lumen(), 0.8, 3.3), cricoidLimit_mm)});
  addThyroidCartilage(into, seed);
  // Mucosa, ligaments and the trachea's muscle.
  into.push_back({kSoftTissue, Kind::kOrgan, 0, shell(lumen(), -0.1, 2.5)});
  for (const Side side : {Side::kRight, Side::kLeft}) {
    into.push_back(
        {kMuscle, Kind::kOrgan, 0,
         column(side, {{{2, {6.5, 8.5, 2.6, 6, 6}}, {8, {5.6, 8, 2.8, 7.5, 4}}, {13, {7, 8, 2, 6, 4}}}, 2, 0.3},
                seed++)});
    into.push_back(
        {kMuscle, Kind::kOrgan, 0.4,
         column(side, {{{-9, {8.5, 4.5, 2, 2, 0}}, {-2, {9.5, 3.5, 3.4, 2.2, 35}}, {4, {11, 5, 3, 2, 45}}}, 2, 0.3},
                seed++)});
  }
  // Inner space of the larynx: paraglottic and pre-epiglottic space.
  into.push_back(
      {kSoftTissue, Kind::kOrgan, 0,
       clip(column(Side::kRight,
                   {{{0, {0, 9, 11, 12, 0}}, {10, {0, 7, 13, 14, 0}}, {24, {0, 6, 15, 14, 0}}, {38, {0, 4, 16, 12, 0}}},
                    4,
                    0.3},
                   seed++),
            [](Vec3 p) { return std::abs(p.x) * 0.84 - (p.y + 9.5) * 0.55; })});
  into.push_back(
      {kBone, Kind::kOrgan, 0.6,
       join(
           {tube(Side::kRight,
                 {{{{0, -14, 35}, 3}, {{9, -11.5, 35.5}, 2.7}, {{17, -3, 37}, 2.1}, {{21.5, 9, 39.5}, 1.8}}, 0.75, 0.2},
                 seed++),
            tube(Side::kLeft,
                 {{{{0, -14, 35}, 3}, {{9, -11.5, 35.5}, 2.7}, {{17, -3, 37}, 2.1}, {{21.5, 9, 39.5}, 1.8}}, 0.75, 0.2},
                 seed++)})});
  // Pharynx above, esophagus below, slightly left of the midline; mucosa lines its collapsed lumen.
  const auto front = [](double z) { return vertebralFront_mm(z); };
  const Curve<5> course{{-80, {4.5, front(-80) - 6, 8, 4.4, 0}},
                        {-50, {5, front(-50) - 6.2, 8, 4.2, 5}},
                        {-30, {4.5, front(-30) - 6, 8, 4, 8}},
                        {-12, {2.5, front(-12) - 5.8, 8.5, 3.7, 5}},
                        {0, {0, front(0) - 5.4, 10, 3, 0}}};
  Curve<5> mucosa = course;
  for (auto& knot : mucosa.knots()) knot.value[2] *= 0.6, knot.value[3] *= 0.3;
  into.push_back({kSoftTissue, Kind::kOrgan, 0, column(Side::kLeft, {mucosa, 3, 0.4}, seed++)});
  into.push_back({kOesophagus, Kind::kOrgan, 0.6, column(Side::kLeft, {course, 3, 0.4}, seed++)});
  into.push_back({kMuscle, Kind::kOrgan, 0.6,
                  column(Side::kRight,
                         {{{-4, {0, front(-4) - 5.6, 10, 2.8, 0}},
                           {10, {0, front(10) - 5.2, 15, 2.6, 0}},
                           {30, {0, front(30) - 5.2, 19, 2.6, 0}},
                           {54, {0, front(54) - 5, 20, 2.6, 0}}},
                          3,
                          0.3},
                         seed++)});
}

}  // namespace insonate::phantom
