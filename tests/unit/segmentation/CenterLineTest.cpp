#include <insonate/cases/Phantom.h>
#include <insonate/segmentation/CenterLine.h>
#include <insonate/tissue/Labels.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace insonate {
namespace {

using Path = std::function<Vec3(double t)>;  ///< t from 0 to 1

std::vector<Vec3> pointsOf(const Path& path, double from = 0, double to = 1) {
  std::vector<Vec3> points;
  for (int n = 0; n <= 600; ++n) points.push_back(path(from + (to - from) * n / 600));
  return points;
}

double distance_mm(const std::vector<Vec3>& points, Vec3 from_mm) {
  double least = std::numeric_limits<double>::max();
  for (const Vec3 p : points) least = std::min(least, norm(p - from_mm));
  return least;
}

/// The middle 40 mm of patient space in voxels as those of a CT.
VolumeGeometry grid(Vec3 spacing_mm = {0.6, 0.6, 1}) {
  VolumeGeometry g;
  g.spacing_mm = spacing_mm;
  for (int a = 0; a < 3; ++a) g.size[a] = static_cast<int>(std::lround(80 / spacing_mm[a])) + 1;
  g.origin_mm = {-40, -40, -40};
  return g;
}

/// Paints what is within a radius of a path.
void paint(LabelMap& labels, const Path& path, double radius_mm, std::uint8_t label = kVein) {
  const VolumeGeometry& g = labels.geometry;
  const Transform indexFromPatient = g.indexFromPatient(), patientFromIndex = g.patientFromIndex();
  for (const Vec3 p : pointsOf(path)) {
    const Vec3 center = indexFromPatient * p;
    std::array<int, 3> first{}, last{};
    for (int a = 0; a < 3; ++a) {
      first[a] = std::max(0, static_cast<int>(center[a] - radius_mm / g.spacing_mm[a]));
      last[a] = std::min(g.size[a] - 1, static_cast<int>(center[a] + radius_mm / g.spacing_mm[a]) + 1);
    }
    for (int k = first[2]; k <= last[2]; ++k)
      for (int j = first[1]; j <= last[1]; ++j)
        for (int i = first[0]; i <= last[0]; ++i)
          if (norm(patientFromIndex * Vec3{double(i), double(j), double(k)} - p) <= radius_mm)
            labels.at(i, j, k) = label;
  }
}

LabelMap tube(const Path& path, double radius_mm, const VolumeGeometry& geometry = grid()) {
  LabelMap labels(geometry, kSoftTissue);
  paint(labels, path, radius_mm);
  return labels;
}

std::vector<CenterLine> linesOf(const LabelMap& labels) {
  const auto lines = centerLines(labels, kVein);
  EXPECT_TRUE(lines) << lines.error().message;
  return *lines;
}

/// The lines lie on the path, but within `cap_mm` of its ends, since a ball has no middle line; and the path, but for
/// `end` of it at either side, on the lines.
void expectAlong(const std::vector<CenterLine>& lines, const Path& path, double cap_mm, double end) {
  constexpr double kMost_mm = 0.3;
  ASSERT_FALSE(lines.empty());
  const auto truth = pointsOf(path);
  for (const CenterLine& line : lines)
    for (const Vec3 p : line) {
      if (norm(p - path(0)) < cap_mm || norm(p - path(1)) < cap_mm) continue;
      EXPECT_LT(distance_mm(truth, p), kMost_mm) << p.x << ' ' << p.y << ' ' << p.z;
    }
  for (const Vec3 p : pointsOf(path, end, 1 - end))
    EXPECT_LT(*distanceToCenterLine_mm(lines, p), kMost_mm) << p.x << ' ' << p.y << ' ' << p.z;
}

Path straight(Vec3 from_mm, Vec3 to_mm) {
  return [=](double t) { return from_mm + (to_mm - from_mm) * t; };
}

TEST(CenterLine, OfTubesThatRunAnyWay) {
  for (const Vec3 axis : {Vec3{0, 0, 1}, Vec3{0.3, -0.2, 1}, Vec3{1, 0, 0}, Vec3{0.8, 0.5, 0.4}, Vec3{0, 1, 0.1}}) {
    SCOPED_TRACE(testing::Message() << axis.x << ' ' << axis.y << ' ' << axis.z);
    const Vec3 half = normalized(axis) * 30;
    const Path path = straight(-half + Vec3{1.3, 0.2, -0.4}, half + Vec3{1.3, 0.2, -0.4});
    const auto lines = linesOf(tube(path, 6));
    EXPECT_EQ(lines.size(), 1u);
    expectAlong(lines, path, 6, 0.1);
  }
}

TEST(CenterLine, OfTheVolumesOwnEdge) {
  const Path path = straight({-9, 4, -60}, {12, -6, 60});
  const auto lines = linesOf(tube(path, 5));
  ASSERT_EQ(lines.size(), 1u);
  expectAlong(lines, path, 5, 0.17);  // all of what is in the volume
  const auto [low, high] = std::minmax(lines[0].front().z, lines[0].back().z);
  EXPECT_LT(low, -39);
  EXPECT_GT(high, 39);
}

/// As a neck turned to one side: an arc of 40 mm radius, and a vein that winds.
TEST(CenterLine, OfCurvedVeins) {
  const Path arc = [](double t) {
    const double a = (t - 0.5) * 100 * std::numbers::pi / 180;
    return Vec3{40 * std::cos(a) - 30, 5, 40 * std::sin(a)};
  };
  expectAlong(linesOf(tube(arc, 6)), arc, 6, 0.1);
  const Path winding = [](double t) {
    const double z = 60 * t - 30;
    return Vec3{6 * std::sin(z / 14), 4 * std::cos(z / 11), z};
  };
  expectAlong(linesOf(tube(winding, 4)), winding, 4, 0.1);
}

/// Wide, 3 mm flat and turned: the middle of the section, though no ball fits there.
TEST(CenterLine, OfAFlatVein) {
  LabelMap labels(grid({0.5, 0.5, 0.75}), kSoftTissue);
  const Path path = straight({2, -3, -35}, {5, 3, 35});
  for (double s = -6; s <= 6; s += 0.25) {
    const Vec3 aside = normalized(Vec3{0.8, 0.6, 0}) * s;
    paint(
        labels, [&](double t) { return path(t) + aside; }, 1.5);
  }
  const auto lines = linesOf(labels);
  EXPECT_EQ(lines.size(), 1u);
  expectAlong(lines, path, 6, 0.15);
}

TEST(CenterLine, OfBothSidesBesideArteriesThatTouchThem) {
  LabelMap labels(grid(), kSoftTissue);
  const Path left = straight({22, 0, -50}, {20, 6, 50}), right = straight({-20, 2, -50}, {-24, 0, 50});
  paint(
      labels,
      [&](double t) {
        return left(t) - Vec3{9.5, 0, 0};
      },
      4, kArtery);
  paint(
      labels,
      [&](double t) {
        return right(t) + Vec3{11, 0, 0};
      },
      4, kArtery);
  paint(labels, left, 5.5);
  paint(labels, right, 7);
  const auto lines = linesOf(labels);
  ASSERT_EQ(lines.size(), 2u);
  const Vec3 onLeft = left(0.5), onRight = right(0.5);
  EXPECT_LT(*distanceToCenterLine_mm(lines, onLeft), 0.3);
  EXPECT_LT(*distanceToCenterLine_mm(lines, onRight), 0.3);
  EXPECT_NEAR(*distanceToCenterLine_mm(lines, onRight + Vec3{3, 0, 0}), 3, 0.3);
  const auto arteries = centerLines(labels, kArtery);
  ASSERT_EQ(arteries->size(), 2u);
  EXPECT_LT(*distanceToCenterLine_mm(*arteries, onLeft - Vec3{9.5, 0, 0}), 0.3);
}

/// A trunk, and a branch as wide that joins it: both have their middle wherever they are apart.
TEST(CenterLine, OfVeinsThatJoin) {
  LabelMap labels(grid(), kSoftTissue);
  const Path trunk = straight({0, 0, -50}, {0, 0, 50}), branch = straight({0, 0, -10}, {50, 5, 8});
  paint(labels, trunk, 5);
  paint(labels, branch, 4);
  const auto lines = linesOf(labels);
  for (const Vec3 p : pointsOf(trunk, 0.11, 0.25)) EXPECT_LT(*distanceToCenterLine_mm(lines, p), 0.3) << p.z;
  for (const Vec3 p : pointsOf(trunk, 0.55, 0.89)) EXPECT_LT(*distanceToCenterLine_mm(lines, p), 0.3) << p.z;
  for (const Vec3 p : pointsOf(branch, 0.35, 0.79)) EXPECT_LT(*distanceToCenterLine_mm(lines, p), 0.3) << p.x;
}

TEST(CenterLine, OnAnObliqueLeftHandedGridOfThickSlices) {
  VolumeGeometry g = grid({0.8, 0.6, 2.5});
  const double c = std::cos(0.3), s = std::sin(0.3);
  g.direction = {{Vec3{c, s, 0}, Vec3{-s, c, 0}, Vec3{0, 0, -1}}};
  g.origin_mm = -(g.direction * Vec3{40, 40, 40});
  const Path path = straight({-4, 3, -30}, {6, -2, 30});
  const auto lines = linesOf(tube(path, 6, g));
  EXPECT_EQ(lines.size(), 1u);
  expectAlong(lines, path, 6, 0.12);
}

/// The built-in neck knows its jugular veins' middle, to which voxels and the walls' unevenness add.
TEST(CenterLine, OfTheBuiltInNeck) {
  for (const char* variant : {"textbook", "collapsed-vein"}) {
    SCOPED_TRACE(variant);
    const auto patient = makePhantom(variant, 1);
    const auto lines = linesOf(patient->labels);
    for (const Target& target : patient->manifest.targets)
      EXPECT_LT(*distanceToCenterLine_mm(lines, target.position_mm), 0.5) << target.name;
  }
}

/// Carotid and subclavian artery join where one of them leaves the volume: a section there reaches the edge, but a line
/// that went straight on would leave its vessel through the wall.
TEST(CenterLine, OfArteriesThatJoinBesideTheVolumesEdge) {
  const auto patient = makePhantom("subclavian", 1);
  const LabelMap& labels = patient->labels;
  const Transform indexFromPatient = labels.geometry.indexFromPatient();
  const auto lines = centerLines(labels, kArtery);
  std::size_t wide = 0;
  for (const CenterLine& line : *lines) {
    if (line.size() < 20) continue;  // thin branches among them
    ++wide;
    for (const Vec3 p : line)
      for (const Vec3 aside : {Vec3{0.5, 0, 0}, Vec3{-0.5, 0, 0}, Vec3{0, 0.5, 0}, Vec3{0, -0.5, 0}}) {
        const Vec3 index = indexFromPatient * (p + aside);
        // An artery that leaves the volume sideways has no neighbor there.
        if (!labels.geometry.contains(int(std::lround(index.x)), int(std::lround(index.y)), int(std::lround(index.z))))
          continue;
        EXPECT_EQ(sampleNearest(labels, index), kArtery) << p.x << ' ' << p.y << ' ' << p.z;
      }
  }
  EXPECT_GE(wide, 6U);
}

TEST(CenterLine, OfCrumbsAndOfNothing) {
  EXPECT_TRUE(linesOf(LabelMap(grid(), kSoftTissue)).empty());
  EXPECT_EQ(distanceToCenterLine_mm(std::span<const CenterLine>(), {0, 0, 0}), std::nullopt);
  EXPECT_TRUE(linesOf(tube([](double) { return Vec3{}; }, 6)).empty()) << "a ball runs nowhere";
  LabelMap one(grid({4, 4, 4}), kSoftTissue);
  one.at(0, 0, 0) = kVein;
  EXPECT_TRUE(linesOf(one).empty());
  LabelMap none;
  none.geometry.size = {0, 1, 1};
  EXPECT_FALSE(centerLines(none, kVein));
  const auto stopped =
      centerLines(tube(straight({0, 0, -30}, {0, 0, 30}), 5), kVein, [](std::string_view, double) { return false; });
  EXPECT_EQ(stopped.error().message, kCancelled);
}

TEST(CenterLine, DistanceIsToTheNearestPieceOfAnyLine) {
  const std::vector<CenterLine> lines{{{0, 0, 0}, {0, 0, 10}}, {{20, 0, 0}, {20, 0, 10}, {20, 10, 10}}};
  EXPECT_DOUBLE_EQ(*distanceToCenterLine_mm(lines, {3, 4, 5}), 5);
  EXPECT_DOUBLE_EQ(*distanceToCenterLine_mm(lines, {0, 0, 13}), 3);
  EXPECT_DOUBLE_EQ(*distanceToCenterLine_mm(lines, {18, 5, 10}), 2);
}

}  // namespace
}  // namespace insonate
