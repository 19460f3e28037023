#include <insonate/cases/Phantom.h>
#include <insonate/tissue/Labels.h>

#include <gmock/gmock.h>
#include <oneapi/tbb/global_control.h>
#include <support/TestData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace insonate {
namespace {

/// A variant is made once for all tests of this program.
const PatientCase& phantom(const std::string& variant) {
  static std::map<std::string, PatientCase> made;
  const auto found = made.find(variant);
  if (found != made.end()) return found->second;
  auto patient = makePhantom(variant, 1);
  EXPECT_TRUE(patient) << patient.error().message;
  return made[variant] = std::move(*patient);
}

struct Blob {
  double area_mm2 = 0;
  Vec3 center_mm;
  int first_i = 0, last_i = 0;  ///< voxels along x
};

std::uint8_t labelAt(const PatientCase& p, Vec3 patient_mm) {
  return sampleNearest(p.labels, p.labels.geometry.indexFromPatient() * patient_mm);
}

/// The connected region of a label in the slice of a seed point, which must carry that label.
Blob sliceRegion(const LabelMap& labels, Vec3 seed_mm) {
  const VolumeGeometry& g = labels.geometry;
  const Vec3 index = g.indexFromPatient() * seed_mm;
  const int i0 = std::lround(index.x), j0 = std::lround(index.y), k = std::lround(index.z);
  const std::uint8_t label = labels.at(i0, j0, k);
  std::vector<char> seen(std::size_t(g.size[0]) * g.size[1]);
  std::vector<std::array<int, 2>> open{{i0, j0}};
  seen[std::size_t(j0) * g.size[0] + i0] = 1;
  Vec3 sum;
  std::size_t n = 0;
  for (; n < open.size(); ++n) {
    const auto [i, j] = open[n];
    sum = sum + Vec3{double(i), double(j), double(k)};
    for (const auto& [a, b] : {std::array{i + 1, j}, {i - 1, j}, {i, j + 1}, {i, j - 1}})
      if (g.contains(a, b, k) && labels.at(a, b, k) == label && !seen[std::size_t(b) * g.size[0] + a]) {
        seen[std::size_t(b) * g.size[0] + a] = 1;
        open.push_back({a, b});
      }
  }
  const auto [first, last] = std::ranges::minmax(open, {}, [](const auto& voxel) { return voxel[0]; });
  return {double(n) * g.spacing_mm.x * g.spacing_mm.y, g.patientFromIndex() * (sum / double(n)), first[0], last[0]};
}

/// Common carotid beside a target: the nearest arterial voxel in its slice.
Vec3 nearestArtery(const LabelMap& labels, Vec3 from_mm) {
  const VolumeGeometry& g = labels.geometry;
  const int k = std::lround((g.indexFromPatient() * from_mm).z);
  Vec3 best;
  double nearest = 1e9;
  for (int j = 0; j < g.size[1]; ++j)
    for (int i = 0; i < g.size[0]; ++i)
      if (labels.at(i, j, k) == kArtery) {
        const Vec3 p = g.patientFromIndex() * Vec3{double(i), double(j), double(k)};
        if (norm(p - from_mm) < nearest) nearest = norm(p - from_mm), best = p;
      }
  return best;
}

/// Distance along the probe's axis from its face to the first voxel of the vein; infinite when it misses.
double veinDepth_mm(const PatientCase& p, const StartPose& pose) {
  for (double d = 0; d < 60; d += 0.1)
    if (labelAt(p, pose.position_mm + pose.axial * d) == kVein && d > 6) return d;
  return INFINITY;
}

std::vector<std::size_t> counts(const LabelMap& labels) {
  std::vector<std::size_t> n(256);
  for (const std::uint8_t v : labels.voxels) ++n[v];
  return n;
}

void expectEveryTissue(const PatientCase& p) {
  const auto n = counts(p.labels);
  for (int label = 0; label < kLabelCount; ++label) EXPECT_GT(n[label], 300u) << "label " << labelTable()[label].name;
  EXPECT_EQ(std::accumulate(n.begin() + kLabelCount, n.end(), std::size_t{0}), 0u);
}

void expectOneGrid(const PatientCase& p) {
  EXPECT_TRUE(sameGrid(p.ct.geometry, p.labels.geometry));
  EXPECT_TRUE(validate(p.ct.geometry));
}

void expectTargetsInVeins(const PatientCase& p) {
  ASSERT_EQ(p.manifest.targets.size(), 2u);
  for (const Target& t : p.manifest.targets) {
    EXPECT_EQ(labelAt(p, t.position_mm), kVein) << t.name;
    EXPECT_EQ(t.label, kVein);
  }
  EXPECT_LT(p.manifest.targets[0].position_mm.x, 0) << "patient right is -x";
}

void expectPosesOnSkin(const PatientCase& p) {
  ASSERT_EQ(p.manifest.startPoses.size(), 4u);
  for (const StartPose& pose : p.manifest.startPoses) {
    SCOPED_TRACE(pose.name);
    EXPECT_NEAR(norm(pose.axial), 1, 1e-9);
    EXPECT_NEAR(norm(pose.lateral), 1, 1e-9);
    EXPECT_NEAR(dot(pose.axial, pose.lateral), 0, 1e-9);
    EXPECT_EQ(labelAt(p, pose.position_mm + pose.axial * 0.75), kSkin);
    EXPECT_EQ(labelAt(p, pose.position_mm - pose.axial * 0.75), kBackground);
    const bool right = pose.name.starts_with("right");
    const Vec3 toVein = p.manifest.targets[right ? 0 : 1].position_mm - pose.position_mm;
    EXPECT_LT(norm(toVein - pose.axial * dot(toVein, pose.axial)), 9) << "vein beside the middle of the picture, mm";
    if (pose.name.ends_with("transverse"))
      EXPECT_GT(pose.lateral.x, 0.5) << "patient left";
    else
      EXPECT_LT(pose.lateral.z, -0.85) << "toward the feet";
  }
}

void expectWholeVeins(const PatientCase& p) {
  const LabelMap& labels = p.labels;
  const VolumeGeometry& g = labels.geometry;
  for (const Target& t : p.manifest.targets) {
    // Follows the region from slice to slice.
    for (const int step : {1, -1}) {
      const int k0 = std::lround((g.indexFromPatient() * t.position_mm).z);
      Vec3 at = t.position_mm;
      for (int k = k0; k >= 0 && k < g.size[2]; k += step) {
        at.z = g.origin_mm.z + k * g.spacing_mm.z;
        ASSERT_EQ(sampleNearest(labels, g.indexFromPatient() * at), kVein) << t.name << " at " << at.z << " mm";
        at = sliceRegion(labels, at).center_mm;
        if (at.z < -42) break;  // below, it joins the subclavian vein and the region is not convex
      }
    }
  }
}

void expectNoHoles(const PatientCase& p) {
  const LabelMap& labels = p.labels;
  const VolumeGeometry& g = labels.geometry;
  for (int k = 0; k < g.size[2]; k += 3)
    for (int j = 0; j < g.size[1]; ++j) {
      int first = -1, last = -1;
      for (int i = 0; i < g.size[0]; ++i)
        if (labels.at(i, j, k)) {
          if (first < 0) first = i;
          last = i;
        }
      // Only near the shoulders may a row leave the body and enter it again.
      if (first < 0 || j * g.spacing_mm.y < 30) continue;
      for (int i = first; i <= last; ++i) ASSERT_NE(labels.at(i, j, k), kBackground) << i << ' ' << j << ' ' << k;
    }
}

/// One test a variant: making one takes seconds, and every test is a program run of its own.
class PhantomVariantTest : public testing::TestWithParam<std::string> {};

TEST_P(PhantomVariantTest, IsAWholeNeck) {
  const PatientCase& p = phantom(GetParam());
  expectOneGrid(p);
  expectEveryTissue(p);
  expectTargetsInVeins(p);
  expectPosesOnSkin(p);
  expectWholeVeins(p);
  expectNoHoles(p);
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const PhantomVariant& v : phantomVariants())
    if (v.region == PhantomRegion::kNeck) all.emplace_back(v.name);
  return all;
}

INSTANTIATE_TEST_SUITE_P(All, PhantomVariantTest, testing::ValuesIn(names()), [](const auto& p) {
  std::string name = p.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(PhantomLabels, AreThoseOfTheCaseOnACoarserGrid) {
  const PatientCase& neck = phantom("textbook");
  VolumeGeometry coarse = neck.labels.geometry;
  constexpr int kStride = 5;
  for (int axis = 0; axis < 3; ++axis) {
    coarse.size[axis] = (coarse.size[axis] - 1) / kStride + 1;
    coarse.spacing_mm[axis] *= kStride;
  }
  const auto labels = phantomLabels("textbook", 1, coarse);
  ASSERT_TRUE(labels) << labels.error().message;
  EXPECT_EQ(labels->vessels, neck.manifest.vessels);
  std::array<int, 256> here{}, there{}, both{};
  int swappedVessels = 0;
  for (int k = 0; k < coarse.size[2]; ++k)
    for (int j = 0; j < coarse.size[1]; ++j)
      for (int i = 0; i < coarse.size[0]; ++i) {
        const std::uint8_t a = labels->labels.at(i, j, k), b = neck.labels.at(kStride * i, kStride * j, kStride * k);
        ++here[a], ++there[b], both[a] += a == b;
        swappedVessels += (a == kVein && b == kArtery) || (a == kArtery && b == kVein);
      }
  EXPECT_EQ(swappedVessels, 0);
  // Skin, fasciae and walls are at least as thick as a voxel, and take from their neighbors.
  for (const Label label : {kArtery, kVein, kNerve, kThyroid, kOesophagus, kAirway, kSternocleidomastoid, kLymphNode,
                            kGland, kBone, kCartilage, kMuscle, kFat, kSkin})
    EXPECT_GT(2.0 * both[label] / (here[label] + there[label]), label == kLymphNode ? 0.85 : 0.93) << labelName(label);
}

TEST(PhantomLabels, RefuseARotatedGridAndAnUnknownCase) {
  VolumeGeometry grid;
  grid.direction.column = {Vec3{0, 1, 0}, Vec3{1, 0, 0}, Vec3{0, 0, 1}};
  const auto rotated = phantomLabels("textbook", 1, grid);
  ASSERT_FALSE(rotated);
  EXPECT_THAT(rotated.error().message, testing::HasSubstr("this grid is rotated"));
  const auto unknown = phantomLabels("giraffe", 1, VolumeGeometry());
  ASSERT_FALSE(unknown);
  EXPECT_THAT(unknown.error().message, testing::HasSubstr("textbook"));
}

TEST(Phantom, HasGradedVariants) {
  EXPECT_GE(phantomVariants().size(), 6u);
  EXPECT_EQ(phantomVariants().front().name, "textbook");
  for (const PhantomVariant& v : phantomVariants())
    EXPECT_THAT(v.difficulty, testing::AnyOf("easy", "moderate", "hard")) << v.name;
}

TEST(Phantom, TextbookHasTheDimensionsOfASupineAdult) {
  const PatientCase& p = phantom("textbook");
  const Target& right = p.manifest.targets[0];
  const Blob vein = sliceRegion(p.labels, right.position_mm);
  EXPECT_NEAR(vein.area_mm2, 112, 20);
  const Blob artery = sliceRegion(p.labels, nearestArtery(p.labels, right.position_mm));
  EXPECT_NEAR(2 * std::sqrt(artery.area_mm2 / M_PI), 6.6, 0.6);
  EXPECT_GT(artery.center_mm.x, vein.center_mm.x + 6) << "carotid medial to the right vein";
  const double depth_mm = veinDepth_mm(p, p.manifest.startPoses[0]);
  EXPECT_GT(depth_mm, 10);
  EXPECT_LT(depth_mm, 20);
  EXPECT_LT(sliceRegion(p.labels, p.manifest.targets[1].position_mm).area_mm2, vein.area_mm2) << "left is smaller";
}

TEST(Phantom, VariantsDifferInWhatTheyPromise) {
  const auto area = [](const char* variant) {
    const PatientCase& p = phantom(variant);
    return sliceRegion(p.labels, p.manifest.targets[0].position_mm).area_mm2;
  };
  EXPECT_LT(area("small-vein"), 0.55 * area("textbook"));
  EXPECT_LT(area("collapsed-vein"), 0.5 * area("textbook"));
  EXPECT_GT(veinDepth_mm(phantom("deep-in-fat"), phantom("deep-in-fat").manifest.startPoses[0]), 20);

  // Seen along the probe, the artery lies behind the vein.
  const auto besideArtery_mm = [](const char* variant) {
    const PatientCase& p = phantom(variant);
    const Vec3 vein = p.manifest.targets[0].position_mm;
    const Vec3 artery = sliceRegion(p.labels, nearestArtery(p.labels, vein)).center_mm;
    return std::abs(dot(artery - vein, p.manifest.startPoses[0].lateral));
  };
  EXPECT_LT(besideArtery_mm("vein-over-artery"), 3);
  EXPECT_GT(besideArtery_mm("textbook"), besideArtery_mm("vein-over-artery") + 3);
  EXPECT_LT(besideArtery_mm("head-turned"), besideArtery_mm("textbook"));
}

/// Share of the right common carotid's width that the vein covers, seen straight from the front at the target's level.
double overlap_percent(const PatientCase& p) {
  const Vec3 target_mm = p.manifest.targets[0].position_mm;
  const Blob vein = sliceRegion(p.labels, target_mm);
  const Blob artery = sliceRegion(p.labels, nearestArtery(p.labels, target_mm));
  const int covered = std::min(vein.last_i, artery.last_i) - std::max(vein.first_i, artery.first_i) + 1;
  return 100.0 * std::max(0, covered) / (artery.last_i - artery.first_i + 1);
}

/// Wang et al., J Emerg Med 2006, 31:283: 156 patients, 29 % of the carotid covered with the head straight and 72 %
/// with it turned by 90 degrees; between them 48 % at 40 degrees.
TEST(Phantom, TurningTheHeadBringsTheVeinOverTheCarotidAsFarAsItDoesInPatients) {
  EXPECT_NEAR(overlap_percent(phantom("head-turned")), 29 + (72 - 29) * 40.0 / 90, 10);
  EXPECT_LT(overlap_percent(phantom("textbook")), 29) << "an easy neck";
}

/// Means of Galloway and Bodenham, Br J Anaesth 2003;90:589, below the middle of the clavicle: vein 12 mm wide, 19 mm
/// below the skin, 3 mm from the artery; rib cage 10 mm behind it, there and 20 mm to the side.
TEST(Phantom, BelowTheClavicleLieVeinArteryRibAndLung) {
  const PatientCase& p = phantom("subclavian");
  expectOneGrid(p);
  ASSERT_EQ(p.manifest.targets.size(), 1u);
  const Target& vein = p.manifest.targets[0];
  ASSERT_EQ(p.manifest.startPoses.size(), 2u);
  for (const StartPose& pose : p.manifest.startPoses) {
    SCOPED_TRACE(pose.name);
    EXPECT_NEAR(dot(pose.axial, pose.lateral), 0, 1e-9);
    EXPECT_EQ(labelAt(p, pose.position_mm + pose.axial * 0.75), kSkin);
    EXPECT_EQ(labelAt(p, pose.position_mm - pose.axial * 0.75), kBackground);
    const Vec3 toVein = vein.position_mm - pose.position_mm;
    EXPECT_LT(norm(toVein - pose.axial * dot(toVein, pose.axial)), 0.5) << "the vein is in the middle of the picture";
    // From wall to wall along the probe's axis.
    const double front = veinDepth_mm(p, pose);
    EXPECT_NEAR(front, 19, 3);
    double back = front;
    while (labelAt(p, pose.position_mm + pose.axial * back) == kVein) back += 0.1;
    EXPECT_NEAR(back - front, 12, 1);
  }
  EXPECT_GT(p.manifest.startPoses[0].lateral.z, 0.7) << "toward the head";
  EXPECT_GT(p.manifest.startPoses[1].lateral.x, 0.7) << "toward the heart";

  double toArtery_mm = 1e9, toBone_mm = 1e9, toLung_mm = 1e9;
  const VolumeGeometry& g = p.labels.geometry;
  for (int k = 0; k < g.size[2]; ++k)
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i) {
        const Vec3 at = g.patientFromIndex() * Vec3{double(i), double(j), double(k)};
        const double from_mm = norm(at - vein.position_mm) - 6;
        const std::uint8_t label = p.labels.at(i, j, k);
        if (label == kArtery) toArtery_mm = std::min(toArtery_mm, from_mm);
        if (label == kBone && at.z < vein.position_mm.z - 6) toBone_mm = std::min(toBone_mm, from_mm);
        if (label == kAirway) toLung_mm = std::min(toLung_mm, from_mm);
      }
  EXPECT_NEAR(toArtery_mm, 3, 1);
  EXPECT_GT(toBone_mm, 8);
  EXPECT_LT(toBone_mm, 22);
  EXPECT_GT(toLung_mm, 10);
  EXPECT_LT(toLung_mm, 30);
}

TEST(Phantom, SameSeedGivesSameBytesOnAnyNumberOfThreads) {
  const PatientCase& parallel = phantom("textbook");
  oneapi::tbb::global_control one(oneapi::tbb::global_control::max_allowed_parallelism, 1);
  const auto serial = makePhantom("textbook", 1);
  ASSERT_TRUE(serial);
  EXPECT_TRUE(serial->labels.voxels == parallel.labels.voxels);
  EXPECT_TRUE(serial->ct.voxels == parallel.ct.voxels);
}

TEST(Phantom, AnotherSeedIsAnotherNeck) {
  const auto other = makePhantom("textbook", 2);
  ASSERT_TRUE(other);
  EXPECT_FALSE(other->labels.voxels == phantom("textbook").labels.voxels);
  EXPECT_EQ(
      sampleNearest(other->labels, other->labels.geometry.indexFromPatient() * other->manifest.targets[0].position_mm),
      kVein);
}

TEST(Phantom, LandmarksLieInWhatTheyName) {
  for (const char* variant : {"textbook", "head-turned", "subclavian"}) {
    SCOPED_TRACE(variant);
    const PatientCase& p = phantom(variant);
    std::map<std::string, int> count;
    for (const Landmark& mark : p.manifest.landmarks) {
      ++count[mark.code];
      if (mark.code == "puncture_site") continue;
      EXPECT_EQ(labelAt(p, mark.position_mm), mark.code == "cricoid" ? kCartilage : kBone) << mark.code;
    }
    EXPECT_EQ(count["cricoid"], 1);
    EXPECT_EQ(count["clavicle_right"] + count["clavicle_left"], 2);
    EXPECT_EQ(count["puncture_site"], int(p.manifest.targets.size()));
  }
}

/// The middle of each named vessel carries its label, and the target lies in the vessel of its name.
TEST_P(PhantomVariantTest, VesselsAreWhereTheirNamesAre) {
  const PatientCase& p = phantom(std::string(GetParam()));
  EXPECT_EQ(p.manifest.vessels.size(), 26U) << "five veins and eight arteries of each side";
  for (const NamedVessel& vessel : p.manifest.vessels) {
    int here = 0, labeled = 0;
    for (const NamedVessel::Point& point : vessel.course) {
      const Vec3 index = p.labels.geometry.indexFromPatient() * point.position_mm;
      if (!p.labels.geometry.contains(int(std::lround(index.x)), int(std::lround(index.y)), int(std::lround(index.z))))
        continue;
      ++here;
      labeled += labelAt(p, point.position_mm) == vessel.label;
    }
    EXPECT_GE(labeled, 0.8 * here) << vessel.name << " of " << here;
  }
  for (const Target& target : p.manifest.targets) {
    const auto named = std::ranges::find(p.manifest.vessels, target.name, &NamedVessel::name);
    ASSERT_NE(named, p.manifest.vessels.end()) << target.name;
    EXPECT_LT(distanceToCenterLine_mm(*named, target.position_mm), 0.5);
    EXPECT_LT(distanceToWall_mm(*named, target.position_mm), -2);
    for (const NamedVessel& other : p.manifest.vessels)
      if (&other != &*named && other.label == kVein) {
        EXPECT_GT(distanceToWall_mm(other, target.position_mm), 0) << other.name;
      }
  }
}

TEST(Phantom, UnknownVariantIsRefusedWithTheList) {
  const auto none = makePhantom("no-such-neck", 1);
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, testing::HasSubstr("vein-over-artery"));
}

TEST(Phantom, CanBeCancelled) {
  const auto cancelled = makePhantom("textbook", 1, [](std::string_view, double) { return false; });
  ASSERT_FALSE(cancelled);
  EXPECT_EQ(cancelled.error().message, kCancelled);
}

}  // namespace
}  // namespace insonate
