#include "ToolGrids.h"

#include <insonate/segmentation/CenterLine.h>
#include <insonate/segmentation/LabelStep.h>
#include <insonate/segmentation/Recipe.h>
#include <insonate/segmentation/StraightenedVessel.h>
#include <insonate/tissue/Labels.h>

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace insonate {
namespace {

using testing::HasSubstr;

constexpr double kReach_mm = 4;

using Course = std::function<Vec3(double part)>;  ///< part of the course, 0 to 1

std::vector<Vec3> lineOf(const Course& course) {
  std::vector<Vec3> points;
  for (int n = 0; n <= 40; ++n) points.push_back(course(n / 40.0));
  return points;
}

std::size_t pixelAt(const ImageSize& size, int x, int y) {
  return std::size_t(y) * std::size_t(size.width) + std::size_t(x);
}

VolumeGeometry cube(Vec3 spacing_mm = {0.5, 0.5, 0.8}) {
  VolumeGeometry g;
  g.spacing_mm = spacing_mm;
  for (int axis = 0; axis < 3; ++axis) g.size[axis] = static_cast<int>(60 / spacing_mm[axis]) + 1;
  g.origin_mm = -g.center_mm();
  return g;
}

double distance_mm(const std::vector<Vec3>& line, Vec3 from_mm) {
  double least = 1e9;
  for (std::size_t n = 1; n < line.size(); ++n) {
    const Vec3 way = line[n] - line[n - 1];
    const double part = std::clamp(dot(from_mm - line[n - 1], way) / dot(way, way), 0.0, 1.0);
    least = std::min(least, norm(from_mm - line[n - 1] - way * part));
  }
  return least;
}

/// A tube of 5 mm radius with CT values of 200 HU in tissue of 0 HU.
struct Tube {
  static constexpr double kRadius_mm = 5;

  Tube(const Course& course, const VolumeGeometry& g, double bulge_mm = 0, Vec3 bulgeAt_mm = {})
      : line(lineOf(course)), ct(g, 0), labels(g, kSoftTissue) {
    const Transform patientFromIndex = g.patientFromIndex();
    for (int k = 0; k < g.size[2]; ++k)
      for (int j = 0; j < g.size[1]; ++j)
        for (int i = 0; i < g.size[0]; ++i) {
          const Vec3 at_mm = patientFromIndex * Vec3{double(i), double(j), double(k)};
          const bool isIn = distance_mm(line, at_mm) <= kRadius_mm;
          if (isIn) ct.at(i, j, k) = 200;
          if (isIn || norm(at_mm - bulgeAt_mm) <= bulge_mm) labels.at(i, j, k) = kVein;
        }
  }
  VesselCourse course() const { return *VesselCourse::make(line); }
  LabelMap changed(const SectionOutline& outline, const std::vector<std::uint8_t>& locked = {}) const {
    LabelMap after = labels;
    LabelEdit edit(ct, after);
    LabelStep step;
    step.tool = step::Outline{outline};
    step.label = kVein;
    step.locked = locked;
    const auto change = perform(step, edit);
    EXPECT_TRUE(change) << change.error().message;
    EXPECT_LE(edit.undoSteps(), 1U);
    return after;
  }

  std::vector<Vec3> line;
  CtVolume ct;
  LabelMap labels;
};

const Course kUpright = [](double part) { return Vec3{2, -1, 25 - 50 * part}; };
const Course kOblique = [](double part) { return Vec3{-14, 10, 16} * (1 - part) + Vec3{14, -8, -18} * part; };
const Course kBow = [](double part) {
  const double a = (part - 0.5) * 1.4;
  return Vec3{30 * std::cos(a) - 22, 0, -30 * std::sin(a)};
};

class Courses : public testing::TestWithParam<Course> {};
INSTANTIATE_TEST_SUITE_P(Shapes, Courses, testing::Values(kUpright, kOblique, kBow));

TEST_P(Courses, FramesArePerpendicularAndTurnAsLittleAsPossible) {
  const auto course = VesselCourse::make(lineOf(GetParam()));
  ASSERT_TRUE(course);
  EXPECT_NEAR(course->step_mm(), 1, 0.1);
  const auto& frames = course->frames();
  for (std::size_t n = 0; n < frames.size(); ++n) {
    EXPECT_NEAR(dot(frames[n].along, frames[n].right), 0, 1e-9);
    EXPECT_NEAR(dot(frames[n].along, frames[n].down), 0, 1e-9);
    EXPECT_NEAR(dot(frames[n].right, frames[n].down), 0, 1e-9);
    EXPECT_NEAR(norm(frames[n].right), 1, 1e-9);
    if (n == 0) continue;
    // A frame that does not turn about the line changes only along the line.
    EXPECT_NEAR(dot(frames[n].right - frames[n - 1].right, frames[n].down), 0, 2e-3);
  }
}

TEST(VesselCourse, BeginsAtTheHeadAndShowsSectionsAsAxialSlices) {
  for (const bool isReversed : {false, true}) {
    auto line = lineOf(kUpright);
    if (isReversed) std::ranges::reverse(line);
    const auto course = VesselCourse::make(line);
    ASSERT_TRUE(course);
    EXPECT_GT(course->frames().front().center_mm.z, course->frames().back().center_mm.z);
    const VesselFrame frame = course->at(0.5 * course->length_mm());
    EXPECT_NEAR(frame.right.x, 1, 1e-6) << "the patient's left is on the right";
    EXPECT_NEAR(frame.down.y, 1, 1e-6) << "posterior is below";
  }
  const auto lying = VesselCourse::make(lineOf([](double part) { return Vec3{20 - 40 * part, 0, 0}; }));
  ASSERT_TRUE(lying);
  EXPECT_LT(lying->frames().front().center_mm.x, 0) << "a horizontal vessel begins on the patient's right";
  EXPECT_NEAR(lying->at(20).down.z, -1, 1e-6);
  const auto stub = VesselCourse::make({{0, 0, 0}, {0, 0, 3}});
  ASSERT_FALSE(stub);
  EXPECT_THAT(stub.error().message, HasSubstr("shorter than 5 mm"));
}

TEST(VesselCourse, ReachesTheEndsOfTheLabel) {
  LabelMap labels(cube());
  const Transform patientFromIndex = labels.geometry.patientFromIndex();
  for (int k = 0; k < labels.geometry.size[2]; ++k)
    for (int j = 0; j < labels.geometry.size[1]; ++j)
      for (int i = 0; i < labels.geometry.size[0]; ++i) {
        const Vec3 p = patientFromIndex * Vec3{double(i), double(j), double(k)};
        if (std::hypot(p.x, p.y) < 4 && p.z > -20 && p.z < 12) labels.at(i, j, k) = kVein;
      }
  const CenterLine line = extendedToEnds({{0, 0, -5}, {0, 0, 0}, {0, 0, 5}}, labels, kVein);
  EXPECT_NEAR(line.front().z, -20, 1);
  EXPECT_NEAR(line.back().z, 12, 1);
  EXPECT_EQ(extendedToEnds({{0, 0, -5}, {0, 0, 5}}, labels, kArtery).size(), 2U);
}

TEST(VesselCourse, ALeakDoesNotDivideTheCourse) {
  const Tube leaking(kUpright, cube(), 7, {10, -1, 2});
  const auto lines = centerLines(leaking.labels, kVein);
  ASSERT_TRUE(lines);
  const auto joined = joinedLines(*lines, leaking.labels, kVein);
  const auto longest = std::ranges::max_element(joined, {}, &CenterLine::size);
  ASSERT_NE(longest, joined.end());
  const auto course = VesselCourse::make(*longest);
  ASSERT_TRUE(course);
  EXPECT_GT(course->length_mm(), 42) << lines->size() << " lines before, " << joined.size() << " after";
  for (const VesselFrame& frame : course->frames())
    EXPECT_LT(std::hypot(frame.center_mm.x - 2, frame.center_mm.y + 1), 1.5);
}

TEST(VesselCourse, LinesBesideEachOtherAreNotJoined) {
  const LabelMap labels(cube(), kVein);
  const CenterLine a{{0, 0, 0}, {0, 0, 5}, {0, 0, 10}}, beside{{6, 0, 20}, {6, 0, 10}, {6, 0, 0}},
      behind{{0.5, 0, 18}, {0.5, 0, 24}};
  EXPECT_EQ(joinedLines({a, beside}, labels, kVein).size(), 2U);
  EXPECT_EQ(joinedLines({a, behind}, labels, kVein).size(), 1U);
  EXPECT_EQ(joinedLines({a, behind}, labels, kArtery).size(), 2U) << "the label is not between them";
}

TEST_P(Courses, TheStraightenedTubeIsABandOfTheTubesDiameter) {
  const Tube tube(GetParam(), cube());
  const VesselCourse course = tube.course();
  const ImageSize size{static_cast<int>(course.length_mm() / 0.25), 80, 0.25};
  for (const double angle : {0.0, 0.7, 2.0}) {
    const ResampledImage image = straightened({tube.ct, tube.labels}, course, 0, angle, size);
    for (int x = 20; x < size.width - 20; x += 5) {
      double bright = 0, labeled = 0;
      for (int y = 0; y < size.height; ++y) {
        bright += image.hu[pixelAt(size, x, y)] / 200.0;
        labeled += image.labels[pixelAt(size, x, y)] == kVein;
      }
      EXPECT_NEAR(bright * size.mm_per_px, 2 * Tube::kRadius_mm, 0.5) << x;
      EXPECT_NEAR(labeled * size.mm_per_px, 2 * Tube::kRadius_mm, 0.9) << x;
    }
  }
}

TEST_P(Courses, ACrossSectionOfATubeIsADisk) {
  const Tube tube(GetParam(), cube());
  const VesselCourse course = tube.course();
  const ImageSize size{80, 80, 0.25};
  const ResampledImage image = crossSection({tube.ct, tube.labels}, course.at(0.4 * course.length_mm()), size);
  double area_mm2 = 0, x_mm = 0;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const double share = image.hu[pixelAt(size, x, y)] / 200.0;
      area_mm2 += share * 0.25 * 0.25;
      x_mm += share * 0.25 * 0.25 * (x + 0.5 - 40) * 0.25;
    }
  EXPECT_NEAR(area_mm2, std::numbers::pi * 25, 3);
  EXPECT_NEAR(x_mm / area_mm2, 0, 0.2);
}

TEST(StraightenedVessel, PixelsBeyondCtAndCourseAreMarked) {
  const Tube tube(kUpright, cube());
  const VesselCourse course = tube.course();
  const ResampledImage image = straightened({tube.ct, tube.labels}, course, -5, 0, {600, 400, 0.25});
  EXPECT_EQ(image.hu[200 * 600], ResampledImage::kOutside) << "before the course";
  EXPECT_EQ(image.hu[200 * 600 + 599], ResampledImage::kOutside) << "behind the course";
  EXPECT_EQ(image.hu[100], ResampledImage::kOutside) << "outside the CT";
  EXPECT_EQ(image.hu[200 * 600 + 100], 200);
}

TEST(StraightenedVessel, AProposalReplacesTheLabelsThatItWouldChange) {
  const Tube tube(kUpright, cube());
  Selection all(tube.labels.geometry, boxOf(tube.labels.geometry));
  Proposal proposal{all.box, std::move(all.mask)};
  std::ranges::fill(proposal.labels.voxels, Proposal::kKeep);
  const auto [i, j, k] = nearestVoxel(tube.labels.geometry.indexFromPatient() * Vec3{2, -1, 0});
  proposal.labels.at(i, j, k) = kBone;
  const ImageSize size{21, 21, 0.5};
  const ResampledImage image = crossSection({tube.ct, tube.labels, &proposal}, tube.course().at(25), size);
  EXPECT_EQ(image.labels[10 * 21 + 10], kBone);
  EXPECT_EQ(image.labels[10 * 21 + 13], kVein);
  const ResampledImage again = crossSection({tube.ct, tube.labels}, tube.course().at(25), size, &image);
  EXPECT_EQ(again.hu, image.hu);
  EXPECT_EQ(again.labels[10 * 21 + 10], kVein);
}

TEST_P(Courses, TheOutlineOfATubeIsACircle) {
  for (const Vec3 spacing_mm : {Vec3{0.5, 0.5, 0.8}, Vec3{0.8, 0.8, 1.5}}) {
    const Tube tube(GetParam(), cube(spacing_mm));
    const VesselCourse course = tube.course();
    const VesselOutline outline = outlineOf(tube.labels, kVein, course.at(0.6 * course.length_mm()));
    double mean_mm = 0;
    for (const double radius_mm : outline.radius_mm) {
      EXPECT_NEAR(radius_mm, Tube::kRadius_mm, 0.6 * norm(spacing_mm));
      mean_mm += radius_mm / VesselOutline::kRays;
    }
    EXPECT_NEAR(mean_mm, Tube::kRadius_mm, 0.25);
  }
}

TEST(SectionOutline, ADragMovesTheNeighborsLessAndTheOtherSideNotAtAll) {
  VesselOutline circle{{}, {1, 0, 0}, {0, 1, 0}, {}};
  circle.radius_mm.fill(5);
  const VesselOutline moved = dragged(circle, 1, 8);
  EXPECT_DOUBLE_EQ(moved.radius_mm[1], 8);
  EXPECT_GT(moved.radius_mm[0], 7);
  EXPECT_NEAR(moved.radius_mm[34], moved.radius_mm[4], 1e-12) << "around the first ray";
  EXPECT_DOUBLE_EQ(moved.radius_mm[7], 5);
  EXPECT_DOUBLE_EQ(moved.radius_mm[20], 5);
  VesselOutline bulged = circle;
  bulged.radius_mm[0] = 8;
  EXPECT_EQ(dragged(bulged, 0, 5).radius_mm, circle.radius_mm) << "the wall beside a bulge stays";
  EXPECT_GT(dragged(circle, 0, -3).radius_mm[0], 0) << "never through the center";
}

TEST_P(Courses, AnUnchangedOutlineChangesNothing) {
  const Tube tube(GetParam(), cube());
  const VesselCourse course = tube.course();
  const std::size_t frame = course.frames().size() / 2;
  const VesselOutline same = outlineOf(tube.labels, kVein, course.frames()[frame]);
  EXPECT_EQ(tube.changed(outlineStep(course, frame, same, kReach_mm)).voxels, tube.labels.voxels);
}

TEST_P(Courses, ABulgeIsRemovedByDraggingTheOutlineBack) {
  const Course course = GetParam();
  const Tube clean(course, cube());
  const VesselCourse way = clean.course();
  const std::size_t frame = way.frames().size() / 2;
  const VesselFrame& section = way.frames()[frame];
  // A ball at the wall that reaches 2 mm beyond it.
  const Tube bulged(course, cube(), 2.5, section.center_mm + section.right * 4.5);
  ASSERT_NE(bulged.labels.voxels, clean.labels.voxels);
  VesselOutline outline = outlineOf(bulged.labels, kVein, section);
  EXPECT_GT(outline.radius_mm[0], 6.5);
  for (const int ray : {0, 2, VesselOutline::kRays - 2}) outline = dragged(outline, ray, Tube::kRadius_mm);
  const LabelMap after = bulged.changed(outlineStep(way, frame, outline, kReach_mm));
  std::size_t before = 0, left = 0;
  for (std::size_t n = 0; n < after.voxels.size(); ++n) {
    before += bulged.labels.voxels[n] != clean.labels.voxels[n];
    left += after.voxels[n] != clean.labels.voxels[n];
  }
  EXPECT_LT(double(left), 0.25 * double(before)) << left << " of " << before;
}

/// Voxels that differ, with their places along and beside the section.
void expectChangesWithin(const LabelMap& before, const LabelMap& after, const VesselFrame& section, double reach_mm,
                         const std::function<bool(Vec3)>& mayChange) {
  const VolumeGeometry& g = before.geometry;
  const Transform patientFromIndex = g.patientFromIndex();
  std::size_t changed = 0;
  for (int k = 0; k < g.size[2]; ++k)
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i) {
        if (before.at(i, j, k) == after.at(i, j, k)) continue;
        const Vec3 at_mm = patientFromIndex * Vec3{double(i), double(j), double(k)};
        ++changed;
        ASSERT_LE(std::abs(dot(at_mm - section.center_mm, section.along)), reach_mm);
        ASSERT_TRUE(mayChange(at_mm));
      }
  EXPECT_GT(changed, 50U);
}

TEST_P(Courses, NothingChangesBeyondTheReachOrOnTheOtherSide) {
  const Tube tube(GetParam(), cube());
  const VesselCourse course = tube.course();
  const std::size_t frame = course.frames().size() / 2;
  const VesselFrame& section = course.frames()[frame];
  for (const double radius_mm : {2.5, 8.0}) {
    const VesselOutline outline = dragged(outlineOf(tube.labels, kVein, section), 9, radius_mm);
    const LabelMap after = tube.changed(outlineStep(course, frame, outline, kReach_mm));
    // A curved tube is up to 10 mm wide, so that planes at the reach are tilted.
    expectChangesWithin(tube.labels, after, section, kReach_mm + 1.3,
                        [&](Vec3 at_mm) { return dot(at_mm - section.center_mm, section.down) > 0; });
    const VesselOutline result = outlineOf(after, kVein, section);
    EXPECT_NEAR(result.radius_mm[9], radius_mm, 0.5);
    EXPECT_NEAR(result.radius_mm[27], Tube::kRadius_mm, 0.4);
  }
}

TEST_P(Courses, TheWallBetweenChangedSectionsIsSmooth) {
  const Tube tube(GetParam(), cube());
  const VesselCourse course = tube.course();
  const std::size_t frame = course.frames().size() / 2;
  const VesselOutline outline = dragged(outlineOf(tube.labels, kVein, course.frames()[frame]), 18, 8);
  const LabelMap after = tube.changed(outlineStep(course, frame, outline, kReach_mm));
  double last_mm = 8.5;
  for (std::size_t n = frame; n <= frame + 5; ++n) {
    const double radius_mm = outlineOf(after, kVein, course.frames()[n]).radius_mm[18];
    EXPECT_LT(radius_mm, last_mm + 0.4);
    EXPECT_GT(radius_mm, last_mm - 1.9);
    last_mm = radius_mm;
  }
  EXPECT_NEAR(last_mm, Tube::kRadius_mm, 0.4);
}

/// A vein whose outline is dragged 1 mm into its neighbor; returns how many voxels of the neighbor are left, before and
/// after.
std::pair<std::ptrdiff_t, std::ptrdiff_t> draggedInto(std::uint8_t neighbor, const std::vector<std::uint8_t>& locked) {
  Tube tube(kUpright, cube());
  const VesselCourse course = tube.course();
  const VolumeGeometry& g = tube.labels.geometry;
  const Transform patientFromIndex = g.patientFromIndex();
  for (int k = 0; k < g.size[2]; ++k)
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i)
        if ((patientFromIndex * Vec3{double(i), double(j), double(k)}).x > 8.2) tube.labels.at(i, j, k) = neighbor;
  const std::size_t frame = course.frames().size() / 2;
  const VesselOutline outline = dragged(outlineOf(tube.labels, kVein, course.frames()[frame]), 0, 9);
  const LabelMap after = tube.changed(outlineStep(course, frame, outline, kReach_mm), locked);
  EXPECT_NE(after.voxels, tube.labels.voxels) << "free voxels still change";
  const auto count = [neighbor](const LabelMap& map) { return std::ranges::count(map.voxels, neighbor); };
  return {count(tube.labels), count(after)};
}

TEST(SectionOutline, ALockedNeighborOrAnotherVesselIsNotChanged) {
  const auto [free, taken] = draggedInto(kMuscle, {});
  EXPECT_LT(taken, free);
  const auto [locked, kept] = draggedInto(kMuscle, {kMuscle});
  EXPECT_EQ(kept, locked);
  const auto [artery, still] = draggedInto(kArtery, {});
  EXPECT_EQ(still, artery);
}

TEST(SectionOutline, ThickSlicesAreReachedToo) {
  EXPECT_DOUBLE_EQ(outlineReach_mm(cube(), {0, 0, 1}), 4);
  const VolumeGeometry thick = cube({0.8, 0.8, 4.5});
  EXPECT_DOUBLE_EQ(outlineReach_mm(thick, {0, 0, 1}), 9);
  EXPECT_DOUBLE_EQ(outlineReach_mm(thick, {1, 0, 0}), 4);
  const Tube tube(kUpright, thick);
  const VesselCourse course = tube.course();
  // Halfway between two slices.
  const Vec3 at_mm = thick.patientFromIndex() * Vec3{0, 0, 6.5};
  const std::size_t frame = course.nearest({2, -1, at_mm.z});
  const VesselFrame& section = course.frames()[frame];
  const VesselOutline outline = dragged(outlineOf(tube.labels, kVein, section), 0, 9);
  const LabelMap after = tube.changed(outlineStep(course, frame, outline, outlineReach_mm(thick, section.along)));
  EXPECT_NEAR(outlineOf(after, kVein, section).radius_mm[0], 9, 1.2);
}

TEST(SectionOutline, RefusesWhatIsNoSection) {
  const Tube tube(kUpright, cube());
  SectionOutline outline =
      outlineStep(tube.course(), 10, outlineOf(tube.labels, kVein, tube.course().frames()[10]), kReach_mm);
  SectionOutline wrong = outline;
  wrong.corners_mm.pop_back();
  EXPECT_THAT(reshapedVessel(tube.labels, kVein, kSoftTissue, wrong).error().message, HasSubstr("36 corners"));
  wrong = outline;
  wrong.section = 99;
  EXPECT_FALSE(reshapedVessel(tube.labels, kVein, kSoftTissue, wrong));
  wrong = outline;
  wrong.corners_mm[3] = {1000, 0, 0};
  EXPECT_THAT(reshapedVessel(tube.labels, kVein, kSoftTissue, wrong).error().message, HasSubstr("corner"));
}

class CutsOnGrids : public test::OnGrids {
 protected:
  /// An upright vessel with a leak to the patient's left, connected by a neck of 3 mm radius.
  void SetUp() override {
    vessel_ = shape([](Vec3 p) { return std::hypot(p.x + 8, p.y) <= 5; });
    leak_ = shape([](Vec3 p) { return norm(p - Vec3{10, 0, 0}) <= 6; });
    neck_ = shape([](Vec3 p) { return p.x > -8 && p.x < 10 && std::hypot(p.y, p.z) <= 3; });
    labels_ = LabelMap(grid(), kSoftTissue);
    for (std::size_t n = 0; n < labels_.voxels.size(); ++n)
      if (vessel_.mask.voxels[n] || leak_.mask.voxels[n] || neck_.mask.voxels[n]) labels_.voxels[n] = kVein;
  }
  Selection vessel_, leak_, neck_;
  LabelMap labels_;
};
INSONATE_ON_GRIDS(CutsOnGrids);

TEST_P(CutsOnGrids, AStrokeAcrossTheNeckCutsTheLeakOff) {
  for (const Vec3 along : {Vec3{0, 0, 1}, normalized(Vec3{0.1, 0, 1})}) {
    const auto cut = partCutOff(labels_, kVein, {{{0.3, -6, 0}, {0.4, 0, 0}, {0.3, 6, 0}}, along});
    ASSERT_TRUE(cut) << cut.error().message;
    for (std::size_t n = 0; n < labels_.voxels.size(); ++n)
      if (vessel_.mask.voxels[n]) labels_.voxels[n] = kVein;
    std::size_t lost = 0, left = 0;
    for (int k = 0; k < grid().size[2]; ++k)
      for (int j = 0; j < grid().size[1]; ++j)
        for (int i = 0; i < grid().size[0]; ++i) {
          lost += vessel_.isSelected(i, j, k) && cut->isSelected(i, j, k);
          left += leak_.isSelected(i, j, k) && !cut->isSelected(i, j, k);
        }
    EXPECT_EQ(lost, 0U);
    EXPECT_EQ(left, 0U);
  }
}

TEST_P(CutsOnGrids, AStrokeThatDoesNotCutApartIsRefused) {
  const auto beside = partCutOff(labels_, kVein, {{{0, 15, 0}, {5, 15, 0}}, {0, 0, 1}});
  ASSERT_FALSE(beside);
  EXPECT_THAT(beside.error().message, HasSubstr("does not cross"));
  const auto half = partCutOff(labels_, kVein, {{{0, -9, 0}, {0, 0, 0}}, {0, 0, 1}});
  ASSERT_FALSE(half);
  EXPECT_THAT(half.error().message, HasSubstr("still connected"));
  const auto dot = partCutOff(labels_, kVein, {{{0, 1, 0}, {0, 1, 0}}, {0, 0, 1}});
  ASSERT_FALSE(dot);
  EXPECT_THAT(dot.error().message, HasSubstr("two or more"));
}

TEST_P(CutsOnGrids, AStrokeThatGrazesTheEdgeOfTheLabelIsRefused) {
  // A single voxel sticks out of the leak, and the stroke passes between both.
  const VolumeGeometry& g = grid();
  const Transform patientFromIndex = g.patientFromIndex(), indexFromPatient = g.indexFromPatient();
  const auto [i, j, k] = nearestVoxel(indexFromPatient * Vec3{10, 0, 0});
  int out = i;
  while (labels_.at(out, j, k) == kVein) ++out;
  labels_.at(out, j, k) = kVein;
  const Vec3 tip_mm = patientFromIndex * Vec3{double(out), double(j), double(k)};
  const Vec3 inside_mm = patientFromIndex * Vec3{double(out - 1), double(j), double(k)};
  const Vec3 toTip = normalized(tip_mm - inside_mm);
  const Vec3 along = std::abs(toTip.z) < 0.7 ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
  const Vec3 aside = normalized(cross(along, toTip)), middle_mm = (tip_mm + inside_mm) / 2;
  const double half_mm = 0.45 * norm(tip_mm - inside_mm);
  const auto grazed = partCutOff(
      labels_, kVein, {{middle_mm - half_mm * aside, middle_mm + half_mm * aside}, normalized(cross(toTip, aside))});
  ASSERT_FALSE(grazed) << grazed->count() << " voxels";
  EXPECT_THAT(grazed.error().message, HasSubstr("only grazes the label"));
}

TEST(CutOff, AStepGivesTheCutPartTheRestLabel) {
  const Tube tube(kUpright, cube(), 6, {10, -1, 0});
  LabelMap after = tube.labels;
  LabelEdit edit(tube.ct, after);
  LabelStep step;
  step.tool = step::CutOff{{{{7.3, -12, 0}, {7.3, 10, 0}}, {0, 0, 1}}};
  step.label = kVein;
  const auto change = perform(step, edit);
  ASSERT_TRUE(change) << change.error().message;
  EXPECT_GT(change->voxels, 100U);
  const Transform indexFromPatient = tube.labels.geometry.indexFromPatient();
  EXPECT_EQ(sampleNearest(after, indexFromPatient * Vec3{12, -1, 0}), kSoftTissue);
  EXPECT_EQ(sampleNearest(after, indexFromPatient * Vec3{6, -1, 0}), kVein);
}

}  // namespace
}  // namespace insonate
