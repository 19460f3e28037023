#include "Anatomy.h"
#include "phantom/Variation.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace insonate::phantom {
namespace {

constexpr double kJugularEnd_mm = -54;  ///< level of the junction with the subclavian vein

int index(Side side) {
  return side == Side::kRight ? 0 : 1;
}

/// Shifted vessels have their usual place at both ends of the neck.
double middleOfNeck(double z_mm) {
  return std::exp(-std::pow((z_mm + 2) / 30, 4));
}

enum Vessel : std::uint32_t { kSheath, kCarotid, kJugular };

/// Deviation of a vessel from its usual course, {lateral, posterior} mm: carotid and jugular vein deviate mostly
/// together, since they share a sheath.
std::array<double, 2> besideCourse_mm(const NeckParameters& n, Side side, Vessel vessel, double z_mm) {
  const std::uint32_t seed = n.seed + 80 + 10 * index(side);
  const auto [sharedX, sharedY] = tortuosity_mm(seed + kSheath, z_mm, 0.8);
  const auto [ownX, ownY] = tortuosity_mm(seed + vessel, z_mm, 0.35);
  return {sharedX + ownX, sharedY + ownY};
}

/// A vessel as it is drawn, with its name, so that the named course is the drawn one.
struct NamedTube {
  std::string_view name;
  std::vector<Tube::Knot> knots;
  double irregular_mm = 0;
  double oval = 0.035;
};

Shape joined(Side side, const std::vector<NamedTube>& tubes, std::uint32_t seed) {
  std::vector<Shape> shapes;
  for (const NamedTube& one : tubes) shapes.push_back(tube(side, {one.knots, 1, one.irregular_mm, one.oval}, seed++));
  return join(std::move(shapes));
}

/// Common carotid up to its bifurcation, then internal and external; one smooth trunk and two branches.
std::vector<NamedTube> carotids(const NeckParameters& n, Side side) {
  const double s = n.carotidScale, b = n.bifurcation_z_mm;
  const Curve<2> course{{-66, {14, 27}},     {-52, {16.5, 25.5}}, {-40, {19.5, 24.5}}, {-28, {22, 24.5}},
                        {-14, {21.8, 24.6}}, {0, {20.4, 25.2}},   {12, {21.4, 24.7}},  {24, {25, 23.5}},
                        {36, {27, 22.5}},    {54, {28, 25}}};
  const auto on = [&](double z, double dx, double dy, double r) {
    const auto [x, y] = course(z);
    const auto [awayX, awayY] = besideCourse_mm(n, side, kCarotid, z);
    return Tube::Knot{{x + dx + awayX + n.carotidLateral_mm * middleOfNeck(z), y + dy + awayY, z}, r * s};
  };
  std::vector<Tube::Knot> trunk;
  for (double z = -66; z < b - 8; z += 8) trunk.push_back(on(z, 0, 0, 3.25));
  trunk.push_back(on(b - 5, 0, 0, 3.6));
  trunk.push_back(on(b, 0, 0, 4.0));
  return {{"common carotid artery", std::move(trunk), 0.22, 0.05},
          {"internal carotid artery",
           {on(b - 3, 0.4, 0.6, 3.6), on(b + 4, 1.6, 2.2, 3.1), on(b + 11, 2.4, 3.6, 2.5), on(b + 22, 2, 4, 2.4),
            on(b + 50, 2, 5, 2.4)},
           0.1},
          {"external carotid artery",
           {on(b - 3, -0.4, -0.6, 2.8), on(b + 4, -1.6, -2.6, 2.3), on(b + 12, -1.6, -5, 2.1), on(b + 24, 0.5, -7, 2),
            on(b + 50, 2, -8, 1.9)},
           0.1},
          {"superior thyroid artery",
           {on(b + 5, -2, -4, 1.1), {{22, 15, b - 4}, 1.0}, {{20.5, 9.5, b - 17}, 1.0}, {{17.5, 6.5, b - 29}, 0.9}},
           0}};
}

std::vector<NamedTube> subclavianArteries(const NeckParameters& n, Side side) {
  const double medial = side == Side::kRight ? 12 : 18, low = side == Side::kRight ? 0 : 3;
  std::vector<Tube::Knot> subclavian{{{medial, 28 + low, -68}, 5}, {{medial + 3, 28 + low, -56}, 4.4},
                                     {{22, 29, -45}, 4.1},         {{32, 32, -37 - low}, 4},
                                     {{46, 33.5, -38 - low}, 4},   {{60, 32, -46 - low}, 3.9},
                                     {{82, 29, -56 - low}, 3.8}};
  if (n.chest) {
    subclavian.resize(4);
    std::ranges::copy(axillaryArtery(), std::back_inserter(subclavian));
  }
  return {{"subclavian artery", std::move(subclavian), 0.15, 0.02},
          // Outside bone below C6, then in the transverse foramina.
          {"vertebral artery",
           {{{23, 29, -43}, 1.7},
            {{20, 34, -30}, 1.7},
            {{17.5, 41, -18}, 1.7},
            {{17, vertebralFront_mm(-6) + 11.5, -6}, 1.7},
            {{17, vertebralFront_mm(12) + 11.5, 12}, 1.7},
            {{17, vertebralFront_mm(30) + 11.5, 30}, 1.7},
            {{17, vertebralFront_mm(56) + 11.5, 56}, 1.7}},
           0},
          // Includes the thyrocervical trunk.
          {"inferior thyroid artery",
           {{{29, 31, -39}, 1.6},
            {{29, 28.5, -28}, 1.4},
            {{27.5, 31.5, -12}, 1.2},
            {{24, 31.5, -5}, 1.1},
            {{18, 29.5, -9}, 1}},
           0},
          {"transverse cervical artery",
           {{{29, 28.5, -29}, 1.2}, {{38, 22.5, -27}, 1.1}, {{50, 27, -25}, 1.1}, {{62, 40, -22}, 1}},
           0}};
}

Shape jugular(const NeckParameters& n, Side side, std::uint32_t seed) {
  std::vector<Curve<5>::Knot> knots;
  for (double z = kJugularEnd_mm; z <= 56; z += 5) knots.push_back({z, jugularVeinAt(n, side, z)});
  // The carotid is medial to it and behind it.
  return column(side, {Curve<5>(std::move(knots)), 2, 0.35, Form::kFaceted, 150}, seed);
}

std::vector<NamedTube> centralVeins(const NeckParameters& n, Side side) {
  const double toMidline = side == Side::kRight ? -14 : 4;  // the left brachiocephalic vein crosses
  const double scale = 0.5 * (n.veinWidth[index(side)] + 1);
  const std::vector<Tube::Knot> subclavian{
      {{25, 14, -53}, 5}, {{38, 16, -52}, 4.8}, {{52, 19, -51}, 4.8}, {{66, 23, -55}, 4.8}, {{84, 26, -60}, 4.8}};
  return {{"brachiocephalic vein",
           {{{28, 15, -48}, 4.6 * scale},
            {{25, 14, -54}, 5.6 * scale},
            {{-toMidline < 0 ? 12.0 : 14.0, 13, -63}, 6.2},
            {{side == Side::kRight ? 13.0 : 2.0, 14, -72}, 6.6}},
           0.3},
          {"subclavian vein", n.chest ? axillaryVein() : subclavian, 0.3, 0.015}};
}

struct NamedSheet {
  std::string_view name;
  Sheet sheet;
};

/// They run in the fat just outside the investing fascia.
std::vector<NamedSheet> superficialVeins(Side side) {
  return {{"external jugular vein",
           {{{-38, {62, 2, 2.0, 1.4}},
             {-28, {63, -1.3, 2.0, 1.3}},
             {-5, {66, -1.5, 2.1, 1.3}},
             {20, {70, -1.5, 1.9, 1.2}},
             {54, {80, -1.4, 1.6, 1.1}}},
            3,
            0.2,
            Form::kOval}},
          {"anterior jugular vein",
           {{{-50, {7, -1.3, 1.4, 1.0}},
             {0, {side == Side::kRight ? 9.0 : 11.0, -1.4, 1.3, 0.9}},
             {36, {14, -1.6, 1.1, 0.8}}},
            3,
            0.2,
            Form::kOval}}};
}

void addVeins(std::vector<Structure>& into, const NeckParameters& n, Side side, std::uint32_t seed) {
  into.push_back(
      {kVein, Kind::kVein, 0.9, join({jugular(n, side, seed), joined(side, centralVeins(n, side), seed + 1)})});
  seed += 3;
  for (NamedSheet& one : superficialVeins(side))
    into.push_back({kVein, Kind::kVein, 0.3, sheet(side, std::move(one.sheet), seed++)});
}

void addArteries(std::vector<Structure>& into, Side side, const std::vector<NamedTube>& tubes, std::uint32_t seed) {
  constexpr double kBranch_mm = 2;  ///< smaller vessels have a thinner wall and sheath
  std::vector<NamedTube> trunks, branches;
  for (const NamedTube& one : tubes) (one.knots.front().radius_mm < kBranch_mm ? branches : trunks).push_back(one);
  into.push_back({kArtery, Kind::kArtery, 1.0, joined(side, trunks, seed)});
  into.push_back({kArtery, Kind::kArtery, 0.45, joined(side, branches, seed + 5)});
}

/// Adds the courses of one side, whose names begin with the side.
class Courses {
 public:
  Courses(std::vector<VesselCourse>& into, Side side) : into_(into), side_(side) {}

  void add(std::string_view name, Label label, const std::vector<Tube::Knot>& line) {
    VesselCourse course{(side_ == Side::kRight ? "right " : "left ") + std::string(name), label, {}};
    for (const Tube::Knot& knot : line)
      course.line.push_back({{patientX(side_, knot.p_mm.x), knot.p_mm.y, knot.p_mm.z}, knot.radius_mm});
    into_.push_back(std::move(course));
  }
  /// Adds a vessel; a subclavian vessel in two parts, if the part lateral of the first rib is to be called axillary.
  void addSubclavian(std::string_view name, Label label, std::vector<Tube::Knot> line, bool isSplit) {
    const auto rib = std::ranges::find_if(line, [](const Tube::Knot& knot) { return knot.p_mm.x > kFirstRib_mm; });
    if (!isSplit || !name.starts_with("subclavian") || rib == line.end()) return add(name, label, line);
    const std::vector<Tube::Knot> lateral(rib - 1, line.end());
    add(label == kVein ? "axillary vein" : "axillary artery", label, lateral);
    line.erase(rib, line.end());
    add(name, label, line);
  }
  void add(const std::vector<NamedTube>& tubes, Label label) {
    for (const NamedTube& one : tubes) add(one.name, label, centerLine(one.knots));
  }
  void add(const NamedSheet& vein, const BodySurface& body) {
    constexpr double kStep_mm = 4, kRadians = std::numbers::pi / 180;
    const Curve<4>& course = vein.sheet.course;
    std::vector<Tube::Knot> line;
    for (double z = course.first(); z <= course.last(); z += kStep_mm) {
      const auto [angle_deg, depth, halfWidth, halfThickness] = course(z);
      const double angle = angle_deg * kRadians;
      const double radius = body.slice(z).fasciaRadius_mm(side_ == Side::kRight ? angle : -angle) - depth;
      line.push_back({{radius * std::sin(angle), BodySurface::kAxisY_mm - radius * std::cos(angle), z},
                      (halfWidth + halfThickness) / 2});
    }
    add(vein.name, kVein, line);
  }

 private:
  std::vector<VesselCourse>& into_;
  Side side_;
};

}  // namespace

std::array<double, 5> jugularVeinAt(const NeckParameters& n, Side side, double z_mm) {
  // Lateral and posterior position of the center, half width, half height, turn. Positions and sizes are those of
  // supine adults: the vein moves forward and widens toward its lower bulb.
  static const Curve<5> kCourse{
      {-54, {27, 15, 7.4, 6.2, 0}},      {-40, {31, 16, 8.0, 6.6, 15}},  {-28, {33, 16.6, 7.6, 6.1, 26}},
      {-14, {34.2, 17.6, 7.1, 5.6, 34}}, {0, {34, 18.8, 6.9, 5.3, 36}},  {12, {34.6, 21.2, 6.6, 5.2, 32}},
      {24, {35.5, 25, 6.2, 5.1, 22}},    {40, {37.5, 29, 5.6, 4.9, 10}}, {56, {37.5, 31, 5.2, 4.7, 0}}};
  auto v = kCourse(z_mm);
  const int s = index(side);
  const double weight = middleOfNeck(z_mm);
  const auto [awayX, awayY] = besideCourse_mm(n, side, kJugular, z_mm);
  v[0] += awayX - n.veinMedial_mm[s] * weight;
  v[1] += awayY - n.veinForward_mm[s] * weight;
  v[2] *= n.veinWidth[s];
  v[3] *= n.veinHeight[s];
  return v;
}

void addVessels(std::vector<Structure>& into, const NeckParameters& n, std::uint32_t seed) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    addArteries(into, side, carotids(n, side), seed += 10);
    addArteries(into, side, subclavianArteries(n, side), seed += 10);
  }
  for (const Side side : {Side::kRight, Side::kLeft}) addVeins(into, n, side, seed += 10);
}

std::vector<VesselCourse> vesselCourses(const NeckParameters& n, const BodySurface& body) {
  std::vector<VesselCourse> all;
  for (const Side side : {Side::kRight, Side::kLeft}) {
    Courses courses(all, side);
    std::vector<Tube::Knot> jugular;
    for (double z = kJugularEnd_mm; z <= 56; z += 5) {
      const auto [lateral, posterior, halfWidth, halfHeight, turn] = jugularVeinAt(n, side, z);
      jugular.push_back({{lateral, posterior, z}, (halfWidth + halfHeight) / 2});
    }
    courses.add("internal jugular vein", kVein, jugular);
    for (const NamedTube& vein : centralVeins(n, side)) {
      // A tributary is drawn from within the jugular vein; its named course begins where that of the jugular vein ends.
      std::vector<Tube::Knot> line = centerLine(vein.knots);
      std::erase_if(line, [](const Tube::Knot& knot) { return knot.p_mm.z > kJugularEnd_mm && knot.p_mm.x < 30; });
      courses.addSubclavian(vein.name, kVein, std::move(line), n.axillary);
    }
    for (const NamedSheet& vein : superficialVeins(side)) courses.add(vein, body);
    courses.add(carotids(n, side), kArtery);
    for (const NamedTube& artery : subclavianArteries(n, side))
      courses.addSubclavian(artery.name, kArtery, centerLine(artery.knots), n.axillary);
  }
  return all;
}

}  // namespace insonate::phantom
