#include <insonate/cases/CaseFromLabels.h>
#include <insonate/tissue/Labels.h>

#include <gmock/gmock.h>
#include <support/TestData.h>

#include <algorithm>
#include <fstream>

namespace insonate {
namespace {

/// A box of vein (7) and one of bone (9) in an empty grid, as a plain text NRRD with directions (-x, -y, +z).
void writeTinyLabels(const std::filesystem::path& file) {
  constexpr int kSize = 40;
  std::ofstream out(file);
  out << "NRRD0004\ntype: short\ndimension: 3\nspace: left-posterior-superior\nsizes: " << kSize << ' ' << kSize << ' '
      << kSize << "\nspace directions: (-1,0,0) (0,-1,0) (0,0,1)\nkinds: domain domain domain\nencoding: ascii\n"
      << "space origin: (20,20,0)\n\n";
  for (int k = 0; k < kSize; ++k)
    for (int j = 0; j < kSize; ++j)
      for (int i = 0; i < kSize; ++i) {
        const bool vein = i >= 14 && i < 18 && j >= 20 && j < 24;
        const bool bone = i >= 20 && i < 28 && j >= 14 && j < 22;
        out << (vein ? 7 : bone ? 9 : 0) << ' ';
      }
}

class CaseFromLabelsTest : public testing::Test {
 protected:
  void SetUp() override { writeTinyLabels(folder_ / "labels.nrrd"); }
  Result<CaseFromLabelsResult> make(const std::string& map) {
    std::ofstream(folder_ / "map.json") << map;
    return caseFromLabels(folder_ / "labels.nrrd", folder_ / "map.json", {});
  }
  static std::size_t count(const LabelMap& labels, Label label) {
    return std::count(labels.voxels.begin(), labels.voxels.end(), label);
  }
  test::TemporaryFolder folder_;
};

TEST_F(CaseFromLabelsTest, TranslatesNumbersByNameOrNumber) {
  const auto made = make(R"({"labels": {"7": "vein", "9": 12}, "title": "Tiny"})");
  ASSERT_TRUE(made) << made.error().message;
  const LabelMap& labels = made->patient.labels;
  EXPECT_EQ(count(labels, kVein), 4u * 4 * 40);
  EXPECT_EQ(count(labels, kBone), 8u * 8 * 40);
  EXPECT_EQ(count(labels, kBackground), 40u * 40 * 40 - (16 + 64) * 40u);
  EXPECT_EQ(made->patient.manifest.title, "Tiny");
  // Index (16, 22) is at patient (20 - 16, 20 - 22).
  EXPECT_EQ(sampleNearest(labels, labels.geometry.indexFromPatient() * Vec3{4, -2, 10}), kVein);
}

TEST_F(CaseFromLabelsTest, CompletesABodyWithSkinFatAndPoses) {
  const auto made = make(R"({"labels": {"7": "vein", "9": "bone"},
      "complete": {"skin_mm": 2, "fat_mm": 2, "margin_mm": 2},
      "targets": [{"name": "the vein", "number": 7, "z_mm": 20}]})");
  ASSERT_TRUE(made) << made.error().message;
  const PatientCase& p = made->patient;
  EXPECT_EQ(count(p.labels, kVein), 4u * 4 * 40) << "structures stay as they are";
  EXPECT_GT(count(p.labels, kSkin), 2000u);
  EXPECT_GT(count(p.labels, kFat), 500u);
  ASSERT_EQ(p.manifest.targets.size(), 1u);
  EXPECT_NEAR(norm(p.manifest.targets[0].position_mm - Vec3{4.5, -1.5, 20}), 0, 1e-6);
  EXPECT_EQ(p.manifest.targets[0].label, kVein);
  ASSERT_EQ(p.manifest.startPoses.size(), 2u);
  EXPECT_NEAR(p.manifest.startPoses[1].lateral.z, -1, 0.2);
  // From the middle of the body to the skin there is no gap.
  bool inside = true;
  for (double y = 0; y > -19; y -= 0.5) {
    const bool body = sampleNearest(p.labels, p.labels.geometry.indexFromPatient() * Vec3{0, y, 20}) != kBackground;
    EXPECT_FALSE(body && !inside) << "a hole in front of y = " << y;
    inside = body;
  }
  EXPECT_FALSE(inside) << "the body ends before the grid does";
}

TEST_F(CaseFromLabelsTest, CropsAndDrawsTubes) {
  const auto made =
      make(R"({"labels": {"7": "vein", "9": "bone"}, "crop_mm": {"min": [-19, -19, 5], "max": [19, 19, 14]},
      "tubes": [{"label": "airway and lung", "points_mm": [[-10, 10, 0], [-10, 10, 40]], "radius_mm": 3,
                 "wall": "cartilage", "wall_mm": 1.5}]})");
  ASSERT_TRUE(made) << made.error().message;
  const LabelMap& labels = made->patient.labels;
  EXPECT_EQ(labels.geometry.size[2], 10);
  const auto at = [&](Vec3 p) { return sampleNearest(labels, labels.geometry.indexFromPatient() * p); };
  EXPECT_EQ(at({-10, 10, 9}), kAirway);
  EXPECT_EQ(at({-6, 10, 9}), kCartilage);
  EXPECT_EQ(at({-4, 10, 9}), kBackground);
}

TEST_F(CaseFromLabelsTest, SaysWhatIsWrongWithTheMap) {
  const std::pair<const char*, const char*> kBad[] = {
      {R"({"labels": {"7": "vein"}})", "number 9"},
      {R"({"labels": {"7": "vain", "9": "bone"}})", "vain"},
      {R"({"labels": {"seven": "vein"}})", "seven"},
      {R"({"labels": {"7": 99, "9": 1}})", "99"},
      {R"({"lables": {}})", "lables"},
      {R"({})", "labels"},
      {R"(no json)", "JSON"},
      {R"({"labels": {"7": "vein", "9": "bone"}, "complete": {"skin_mm": 90}})", "skin_mm"},
      {R"({"labels": {"7": "vein", "9": "bone"}, "crop_mm": {"min": [500, 500, 500], "max": [600, 600, 600]}})",
       "crop"},
      {R"({"labels": {"7": "background", "9": "background"}, "complete": {}})", "no structure"}};
  for (const auto& [map, mentions] : kBad) {
    const auto made = make(map);
    ASSERT_FALSE(made) << map;
    EXPECT_THAT(made.error().message, testing::HasSubstr(mentions));
  }
  EXPECT_FALSE(caseFromLabels(folder_ / "missing.nrrd", folder_ / "map.json", {}));
  EXPECT_FALSE(caseFromLabels(folder_ / "labels.nrrd", folder_ / "missing.json", {}));
}

TEST_F(CaseFromLabelsTest, AMapOfAnotherFileIsRefused) {
  for (const char* map :
       {R"({"labels": {"70": "vein"}, "others": "soft tissue"})", R"({"labels": {}, "others": "soft tissue"})",
        R"({"labels": {"7": "vein"}, "others": "soft tissue"})"}) {
    const auto made = make(map);
    ASSERT_FALSE(made) << map;
    EXPECT_THAT(made.error().message, testing::HasSubstr("map belongs to this file")) << map;
  }
  EXPECT_TRUE(make(R"({"labels": {"9": "bone"}, "others": "soft tissue"})")) << "four fifths of the voxels are bone";
  const auto aFolder = caseFromLabels(folder_ / "labels.nrrd", folder_.path(), {});
  ASSERT_FALSE(aFolder);
  EXPECT_THAT(aFolder.error().message, testing::HasSubstr("is a folder"));
  EXPECT_THAT(make("{").error().message,
              testing::AllOf(testing::HasSubstr("line 1, column 2"), testing::Not(testing::HasSubstr("exception"))));
}

TEST_F(CaseFromLabelsTest, NotesATargetThatIsNotThere) {
  const auto made = make(R"({"labels": {"7": "vein", "9": "bone"},
      "targets": [{"name": "nothing", "number": 8, "z_mm": 20}]})");
  ASSERT_TRUE(made);
  EXPECT_TRUE(made->patient.manifest.targets.empty());
  ASSERT_EQ(made->notes.size(), 1u);
  EXPECT_THAT(made->notes[0], testing::HasSubstr("nothing"));
}

TEST(CaseFromLabels, CompletesTheHeadAndNeckAtlas) {
  INSONATE_NEEDS_DATA("neck-atlas-labels/HN-Atlas-labels.nrrd");
  const auto made =
      caseFromLabels(test::testData("neck-atlas-labels/HN-Atlas-labels.nrrd"),
                     std::filesystem::path(INSONATE_SOURCE_DIR) / "resources/maps/spl-head-neck.json", {});
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_THAT(made->notes, testing::IsEmpty());
  const PatientCase& p = made->patient;
  const auto at = [&](Vec3 patient_mm) {
    return sampleNearest(p.labels, p.labels.geometry.indexFromPatient() * patient_mm);
  };
  ASSERT_EQ(p.manifest.targets.size(), 2u);
  for (const Target& t : p.manifest.targets) EXPECT_EQ(at(t.position_mm), kVein) << t.name;
  EXPECT_LT(p.manifest.targets[0].position_mm.x, p.manifest.targets[1].position_mm.x) << "not mirrored";
  EXPECT_GE(p.manifest.vessels.size(), 12u);
  for (const NamedVessel& vessel : p.manifest.vessels) {
    const auto labeled = std::ranges::count_if(
        vessel.course, [&](const NamedVessel::Point& point) { return at(point.position_mm) == vessel.label; });
    EXPECT_GE(labeled, 0.7 * double(vessel.course.size())) << vessel.name;
  }
  for (const Target& t : p.manifest.targets) {
    const auto named = std::ranges::find(p.manifest.vessels, t.name, &NamedVessel::name);
    ASSERT_NE(named, p.manifest.vessels.end()) << t.name;
    EXPECT_LT(distanceToCenterLine_mm(*named, t.position_mm), 2);
  }
  ASSERT_EQ(p.manifest.startPoses.size(), 4u);
  for (const StartPose& pose : p.manifest.startPoses) {
    EXPECT_EQ(at(pose.position_mm + pose.axial * 0.4), kSkin) << pose.name;
    EXPECT_EQ(at(pose.position_mm - pose.axial * 0.4), kBackground) << pose.name;
  }
  EXPECT_EQ(at({5, 16, -82}), kAirway);
  for (const Label label : {kSkin, kFat, kMuscle, kSoftTissue, kCartilage, kThyroid, kOesophagus, kSternocleidomastoid})
    EXPECT_GT(std::count(p.labels.voxels.begin(), p.labels.voxels.end(), label), 300) << labelTable()[label].name;
}

}  // namespace
}  // namespace insonate
