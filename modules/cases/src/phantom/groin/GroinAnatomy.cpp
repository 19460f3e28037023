#include "Groin.h"
#include "phantom/Individual.h"
#include "phantom/Variation.h"

#include <algorithm>
#include <cmath>

namespace insonate::phantom {
namespace {

/// Adds muscles, each slightly different from its neighbors in other groins.
class GroinMuscles {
 public:
  GroinMuscles(std::vector<Structure>& into, std::uint32_t seed) : into_(into), seed_(seed) {}

  void add(Column belly) {
    ++seed_;
    add(column(Side::kRight, varied(std::move(belly), seed_), seed_));
  }
  void add(Sheet flat) {
    ++seed_;
    add(sheet(Side::kRight, varied(std::move(flat), seed_), seed_));
  }
  /// Adds a muscle of the abdominal wall, which ends at the inguinal ligament.
  void addAboveLigament(Sheet flat) {
    ++seed_;
    const Shape whole = sheet(Side::kRight, varied(std::move(flat), seed_), seed_);
    add(clip(whole, [](Vec3 p) { return inguinalLigament_mm(-p.x) + 3 - p.z; }));
  }

 private:
  void add(Shape shape) { into_.push_back({kMuscle, Kind::kMuscle, 0, std::move(shape)}); }

  std::vector<Structure>& into_;
  std::uint32_t seed_;
};

/// Femoral head, 46 mm wide, with its center 17 mm below the ligament; the common femoral artery runs in front of its
/// inner third.
Column femoralHead(double radius_mm) {
  constexpr double kX_mm = 17, kY_mm = 50.5, kZ_mm = -17;
  const std::array<double, 5> section{kX_mm, kY_mm, radius_mm, radius_mm, 0};
  return {{{kZ_mm - radius_mm, section}, {kZ_mm + radius_mm, section}}, radius_mm, 0.3};
}

void addNodes(std::vector<Structure>& into, std::uint32_t seed) {
  const auto node = [&](double x, double y, double z, double half_mm, double halfHeight_mm, double halfLength_mm) {
    into.push_back({kLymphNode, Kind::kOrgan, 0.3,
                    column(Side::kRight,
                           {{{z - halfLength_mm, {x, y, half_mm, halfHeight_mm, 10}},
                             {z + halfLength_mm, {x, y, half_mm, halfHeight_mm, 10}}},
                            halfLength_mm,
                            0.3},
                           seed++)});
  };
  // Superficial nodes along the ligament and the great saphenous vein; the deep node in the femoral canal.
  node(12, -2.8, -6, 4.4, 1.9, 5);
  node(-24, -1.4, -24, 4, 2.1, 6.5);
  node(-11, -3, -55, 3.6, 1.8, 7);
  node(-22.5, 13, -10, 2.6, 3.4, 6);
}

/// Iliopsoas, sartorius, tensor fasciae latae, rectus femoris, vastus.
void addFlexors(GroinMuscles& muscles) {
  muscles.add(Column{{{40, {28, 40, 24, 15, 0}},
                      {14, {25, 30, 20, 11, 0}},
                      {-2, {21, 24.5, 17, 8.6, 0}},
                      {-18, {18, 23.5, 14.5, 8.4, 0}},
                      {-36, {15, 27, 12.5, 10, 0}},
                      {-58, {13, 37, 11, 10.5, 0}},
                      {-100, {22, 58, 8, 9, 0}}},
                     4,
                     0.6,
                     Form::kBelly});
  muscles.add(Sheet{{{40, {74, 6, 8, 4}},
                     {20, {66, 6, 11, 4.2}},
                     {0, {55, 5.6, 12.5, 4.4}},
                     {-20, {46, 5.2, 13, 4.5}},
                     {-45, {33, 5, 13, 4.6}},
                     {-70, {19, 5, 12.5, 4.6}},
                     {-104, {5, 5, 12, 4.6}}},
                    5,
                    0.4});
  muscles.add(Sheet{{{10, {84, 9, 12, 5}}, {-30, {80, 9, 16, 7}}, {-104, {76, 8, 15, 6}}}, 5, 0.5});
  muscles.add(Column{
      {{-2, {37, 30, 5, 4, 0}}, {-24, {37, 25, 10, 7, 10}}, {-58, {35, 22, 14, 9, 10}}, {-104, {31, 21, 16, 11, 5}}},
      4,
      0.6,
      Form::kBelly});
  muscles.add(Column{{{-40, {44, 46, 18, 10, 20}}, {-66, {42, 45, 24, 13, 15}}, {-110, {36, 44, 28, 15, 10}}}, 4, 0.7});
}

/// Pectineus, obturator muscles, adductors, gracilis.
void addAdductors(GroinMuscles& muscles) {
  muscles.add(Column{{{4, {-18, 29, 8, 3, 35}},
                      {-12, {-18, 25, 13, 5, 30}},
                      {-28, {-15, 25, 15, 6.4, 20}},
                      {-48, {-8, 30, 14, 7.4, 15}},
                      {-72, {0, 39, 12, 8, 10}},
                      {-104, {10, 52, 9, 7, 0}}},
                     4,
                     0.5,
                     Form::kBelly});
  // Obturator externus and internus.
  muscles.add(Column{
      {{2, {-14, 54, 10, 9, 0}}, {-22, {-10, 50, 17, 11, 10}}, {-48, {-4, 54, 16, 10, 10}}, {-66, {4, 60, 10, 7, 0}}},
      4,
      0.5});
  muscles.add(Column{{{60, {-4, 62, 9, 14, 0}}, {10, {-8, 60, 10, 15, 10}}, {-14, {-10, 64, 10, 8, 0}}}, 4, 0.5});
  // Adductor longus, brevis and magnus, gracilis.
  muscles.add(Column{{{-27, {-39, 17, 5, 3, 20}},
                      {-42, {-35, 17, 12, 5.6, 20}},
                      {-68, {-28, 19.5, 16, 8.4, 15}},
                      {-104, {-22, 23, 17, 9.5, 10}}},
                     4,
                     0.5,
                     Form::kBelly});
  muscles.add(Column{
      {{-34, {-33, 34, 9, 5, 15}}, {-58, {-24, 38, 15, 7.5, 15}}, {-104, {-13, 46, 15, 8, 10}}}, 4, 0.5, Form::kBelly});
  muscles.add(
      Column{{{-40, {-32, 58, 18, 10, 10}}, {-62, {-22, 60, 26, 12, 5}}, {-110, {-10, 64, 28, 13, 0}}}, 4, 0.7});
  muscles.add(Column{{{-36, {-51, 24, 4, 6, 25}}, {-70, {-50, 30, 5, 12, 25}}, {-110, {-48, 36, 6, 14, 25}}}, 4, 0.4});
}

/// Internal oblique and transversus, rectus.
void addAbdominalWall(GroinMuscles& muscles) {
  muscles.addAboveLigament(
      Sheet{{{-30, {-8, 6, 16, 3.4}}, {4, {22, 6, 34, 4}}, {24, {36, 6.5, 44, 4.6}}, {60, {40, 7, 50, 5.4}}}, 3, 0.4});
  muscles.addAboveLigament(
      Sheet{{{-36, {-58, 5.6, 12, 4}}, {0, {-52, 5.8, 17, 4.8}}, {60, {-46, 6, 20, 5.4}}}, 3, 0.4});
}

}  // namespace

void addGroinSkeleton(std::vector<Structure>& into, std::uint32_t seed) {
  constexpr double kHead_mm = 21.5;
  const Column head = femoralHead(kHead_mm);
  const auto bone = [&](std::vector<Tube::Knot> knots) {
    return tube(Side::kRight, {std::move(knots), 1, 0.5}, seed++);
  };
  const Shape surface = column(Side::kRight, head, seed++);
  std::vector<Shape> bones{surface};
  // Neck of the femur, trochanters and shaft.
  bones.push_back(bone({{{20, 54, -19}, 15}, {{40, 60, -34}, 15}, {{54, 63, -44}, 18}}));
  bones.push_back(bone({{{52, 63, -48}, 16}, {{48, 63, -66}, 14.5}, {{44, 63, -95}, 14}}));
  bones.push_back(bone({{{30, 72, -60}, 7}, {{38, 68, -66}, 9}}));
  // Front of the acetabulum, superior ramus and body of the pubis, and its lower ramus.
  bones.push_back(
      bone({{{8, 50, 10}, 12}, {{-4, 42, 4}, 9}, {{-17, 36, -8}, 7.5}, {{-30, 27, -20}, 7}, {{-39, 21, -29}, 6.5}}));
  bones.push_back(bone({{{-39, 22, -29}, 6.5}, {{-52, 27, -34}, 9}, {{-66, 30, -36}, 9}}));
  bones.push_back(bone({{{-44, 32, -38}, 7}, {{-42, 52, -60}, 6}, {{-30, 70, -74}, 8}}));
  // Ilium with the lower front spine.
  bones.push_back(bone({{{20, 66, 10}, 17}, {{28, 62, 24}, 14}, {{36, 60, 45}, 12}}));
  bones.push_back(bone({{{34, 44, 10}, 7}, {{32, 54, 20}, 10}}));
  into.push_back({kBone, Kind::kOrgan, 0.4, join(std::move(bones))});
  // Only in front, where no other bone joins the head.
  const auto isJoined_mm = [](Vec3 p) { return std::max({p.y - 54, -p.x - 27, p.z + 4}); };
  into.push_back({kCartilage, Kind::kOrgan, 0, clip(shell(surface, 0, 1.4), isJoined_mm)});
  into.push_back({kSoftTissue, Kind::kOrgan, 0, shell(surface, 1.3, 2.9)});  // joint capsule
  // Inguinal ligament, from the front spine of the ilium to the pubic tubercle.
  const auto onLigament = [](double x, double y) { return Vec3{x, y, inguinalLigament_mm(x)}; };
  into.push_back({kSoftTissue, Kind::kOrgan, 0,
                  tube(Side::kRight,
                       {{{onLigament(-41, 15), 2.6},
                         {onLigament(-26, 8), 2.2},
                         {onLigament(-12, 4.2), 1.9},
                         {onLigament(0, 3.4), 1.8},
                         {onLigament(18, 5.6), 1.9},
                         {onLigament(36, 11), 2.1},
                         {onLigament(58, 22), 2.4}},
                        1,
                        0.2},
                       seed + 1)});
}

void addGroinNerves(std::vector<Structure>& into, std::uint32_t seed) {
  // Femoral nerve, flat on the iliopsoas and lateral of the artery; it splits 3 to 4 cm below the ligament.
  std::vector<Shape> nerves{column(Side::kRight,
                                   {{{32, {18, 27, 3.4, 2.2, 10}},
                                     {12, {15, 18, 4, 1.9, 5}},
                                     {0, {13.4, 13.6, 4.6, 1.7, 5}},
                                     {-16, {12.8, 12, 5, 1.5, 0}},
                                     {-36, {13, 12.6, 5, 1.3, 0}}},
                                    4,
                                    0.25},
                                   seed)};
  const auto branch = [&](std::vector<Tube::Knot> knots) {
    nerves.push_back(tube(Side::kRight, {std::move(knots), 1, 0.1, 0.1}, ++seed));
  };
  branch({{{10, 12.2, -32}, 1.2}, {{7.5, 12, -48}, 1.1}, {{5, 13.4, -70}, 1}, {{3, 16, -92}, 1}});
  branch({{{13, 12.8, -33}, 1.2}, {{16, 16, -50}, 1.2}, {{20, 22, -68}, 1}, {{24, 28, -92}, 1}});
  branch({{{15, 12.8, -32}, 1}, {{21, 12, -44}, 0.9}, {{25, 12, -56}, 0.8}});
  into.push_back({kNerve, Kind::kOrgan, 0.45, join(std::move(nerves))});
  addNodes(into, seed + 1);
}

void addGroinMuscles(std::vector<Structure>& into, std::uint32_t seed) {
  GroinMuscles muscles(into, seed);
  addFlexors(muscles);
  addAdductors(muscles);
  addAbdominalWall(muscles);
}

}  // namespace insonate::phantom
