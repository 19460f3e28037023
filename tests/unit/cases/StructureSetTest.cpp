#include "StructureFiles.h"
#include "support/TestData.h"

#include <insonate/cases/LabelFile.h>
#include <insonate/image/VoxelBox.h>

#include <gmock/gmock.h>

#include <algorithm>

namespace insonate {
namespace {

namespace fs = std::filesystem;
using gdcm::DataSet;
using gdcm::Tag;
using gdcm::VR;
using test::ball;
using test::circle;
using test::Contour;
using testing::Contains;
using testing::HasSubstr;

std::vector<double> everyStep(double from, double to, double step) {
  std::vector<double> z;
  for (double at = from; at <= to + 1e-9; at += step) z.push_back(at);
  return z;
}

/// The second reading of a shape: each voxel whose center is inside.
double diceWith(const LabelMap& labels, std::uint8_t label, const std::function<bool(Vec3)>& isInside) {
  const Transform patientFromIndex = labels.geometry.patientFromIndex();
  double both = 0, sum = 0;
  for (int k = 0; k < labels.geometry.size[2]; ++k)
    for (int j = 0; j < labels.geometry.size[1]; ++j)
      for (int i = 0; i < labels.geometry.size[0]; ++i) {
        const bool a = labels.at(i, j, k) == label;
        const bool b = isInside(patientFromIndex * Vec3{double(i), double(j), double(k)});
        both += a && b;
        sum += int(a) + int(b);
      }
  return 2 * both / sum;
}

double volumeOf(const LabelMap& labels, std::uint8_t label) {
  const Vec3 s = labels.geometry.spacing_mm;
  return double(std::ranges::count(labels.voxels, label)) * s.x * s.y * s.z;
}

class StructureSets : public testing::Test {
 protected:
  explicit StructureSets() { useGrid(test::grid({80, 70, 40}, {0.7, 0.7, 1}, {-28, -24, -20})); }

  void useGrid(const VolumeGeometry& grid) {
    patient.ct = CtVolume(grid, 40);
    patient.labels = LabelMap(grid);
  }
  LabelReadResult read(const std::vector<test::SentStructure>& structures, const StructureChoices& choices = {}) {
    test::writeStructureSet(file, structures);
    auto result = importLabels(patient, file, {{}, false, choices});
    EXPECT_TRUE(result) << result.error().message;
    return result ? std::move(*result) : LabelReadResult{};
  }
  std::string refusal(const std::vector<test::SentStructure>& structures,
                      const std::function<void(DataSet&)>& edit = {}) {
    test::writeStructureSet(file, structures, edit);
    const auto result = importLabels(patient, file);
    EXPECT_FALSE(result);
    return result ? "" : result.error().message;
  }
  /// Refusal after a change of the first contour of the first structure.
  std::string refusalOf(Tag tag, VR::VRType vr, const std::string& text) {
    return refusal({{"Vein", ball({}, 8, {0})}}, [&](DataSet& data) {
      DataSet roi, contour = test::sentContour(circle({}, 8), "CLOSED_PLANAR");
      test::setText(contour, tag, vr, text);
      test::setText(roi, Tag(0x3006, 0x0084), VR::IS, "1");
      test::setSequence(roi, Tag(0x3006, 0x0040), {contour});
      test::setSequence(data, Tag(0x3006, 0x0039), {roi});
    });
  }

  test::TemporaryFolder folder;
  const fs::path file = folder / "RS.dcm";
  PatientCase patient;
};

TEST_F(StructureSets, VoxelBelongsToAContourIfItsCenterIsInside) {
  useGrid(test::grid({10, 10, 5}, {1, 1, 3}));
  const Contour box{{1.6, 2.6, 6}, {4.4, 2.6, 6}, {4.4, 6.4, 6}, {1.6, 6.4, 6}};
  const auto labels = read({{"Vein", {box}}}).labels;
  EXPECT_EQ(std::ranges::count(labels.voxels, kVein), 3 * 4);
  for (int j = 3; j <= 6; ++j)
    for (int i = 2; i <= 4; ++i) EXPECT_EQ(labels.at(i, j, 2), kVein);
}

TEST_F(StructureSets, CylinderHasItsVolume) {
  std::vector<Contour> contours;
  for (const double z : everyStep(-10, 10, 1)) contours.push_back(circle({3, -2, z}, 9));
  const auto result = read({{"Jugular vein left", contours}});
  EXPECT_NEAR(volumeOf(result.labels, kVein), std::numbers::pi * 81 * 21, 0.01 * std::numbers::pi * 81 * 21);
  EXPECT_GT(
      diceWith(result.labels, kVein, [](Vec3 p) { return std::hypot(p.x - 3, p.y + 2) < 9 && std::abs(p.z) < 10.5; }),
      0.999);
  EXPECT_THAT(result.notes, testing::IsEmpty());
}

TEST_F(StructureSets, ContourWithinAContourIsAHole) {
  std::vector<Contour> rings, keyholes;
  for (const double z : everyStep(-4, 4, 1)) {
    const double half = std::sqrt(25 - z * z);
    const Contour outer = circle({0, 0, z}, 12 + half), inner = circle({0, 0, z}, 12 - half);
    rings.push_back(outer);
    rings.push_back(inner);
    // From the last corner of the outer circle to the inner one, around it the other way, and back.
    Contour keyhole = outer;
    keyhole.push_back(outer.front());
    keyhole.push_back(inner.front());
    keyhole.insert(keyhole.end(), inner.rbegin(), inner.rend());
    keyhole.push_back(outer.front());
    keyholes.push_back(keyhole);
  }
  const auto isInTorus = [](Vec3 p) { return std::hypot(std::hypot(p.x, p.y) - 12, p.z) < 5; };
  const auto byRings = read({{"Vein", rings}}), byKeyholes = read({{"Vein", keyholes}});
  EXPECT_GT(diceWith(byRings.labels, kVein, isInTorus), 0.995);
  EXPECT_GT(diceWith(byKeyholes.labels, kVein, isInTorus), 0.995);
}

TEST_F(StructureSets, ASliceMayHaveSeveralContours) {
  std::vector<Contour> contours;
  for (const double z : everyStep(-5, 5, 1))
    for (const double x : {-14.0, 14.0}) contours.push_back(circle({x, 0, z}, 6));
  contours.push_back(contours.front());  // A contour that is in the file twice is no hole.
  const auto result = read({{"Artery", contours}});
  EXPECT_GT(diceWith(result.labels, kArtery,
                     [](Vec3 p) { return std::hypot(std::abs(p.x) - 14, p.y) < 6 && std::abs(p.z) < 5.5; }),
            0.999);
}

TEST_F(StructureSets, SlicesBetweenContoursAreInterpolated) {
  useGrid(test::grid({80, 70, 16}, {0.7, 0.7, 3}, {-28, -24, -21}));
  const auto isInBall = [](Vec3 p) { return norm(p) < 18; };
  const auto every = read({{"Gland", ball({}, 18, everyStep(-21, 24, 3))}});
  EXPECT_GT(diceWith(every.labels, kGland, isInBall), 0.995);
  EXPECT_THAT(every.notes, Not(Contains(HasSubstr("interpolated"))));
  const auto everySecond = read({{"Gland", ball({}, 18, everyStep(-15, 24, 6))}});
  EXPECT_GT(diceWith(everySecond.labels, kGland, isInBall), 0.985);
  EXPECT_THAT(everySecond.notes, Contains(HasSubstr("got an interpolated shape: 5 slices of 1 structure.")));
}

TEST_F(StructureSets, LargeGapsAndTheEndsStayEmpty) {
  const auto result = read({{"Vein", {circle({0, 0, -8}, 6), circle({0, 0, 6}, 6)}}});
  for (int k = 0; k < 40; ++k) EXPECT_EQ(result.labels.at(40, 34, k) != 0, k == 12 || k == 26) << k;
}

/// The CT may have been reconstructed again, with other slices than the CT on which the contours were drawn.
TEST_F(StructureSets, ContoursOfOtherSlicesComeToTheirPlace) {
  const auto isInBall = [](Vec3 p) { return norm(p) < 15; };
  useGrid(test::grid({80, 70, 12}, {0.7, 0.7, 3}, {-28, -24, -16.5}));
  // The slab of the outermost contours reaches beyond the ball.
  EXPECT_GT(diceWith(read({{"Gland", ball({}, 15, everyStep(-15, 15, 3))}}).labels, kGland, isInBall), 0.95);
  useGrid(test::grid({80, 70, 80}, {0.7, 0.7, 0.5}, {-28, -24, -20.2}));
  EXPECT_GT(diceWith(read({{"Gland", ball({}, 15, everyStep(-15, 15, 3))}}).labels, kGland, isInBall), 0.97);
  useGrid(test::grid({80, 70, 12}, {0.7, 0.7, 3}, {-28, -24, -18}));
  EXPECT_GT(diceWith(read({{"Gland", ball({}, 15, everyStep(-15, 15, 0.5))}}).labels, kGland, isInBall), 0.99);
}

/// Feet first, and any other orientation: contours are given in patient coordinates.
TEST_F(StructureSets, OrientationOfTheSlicesDoesNotMatter) {
  for (const Mat3& direction : {test::obliqueDirection(), Mat3{{Vec3{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}}},
                                Mat3{{Vec3{0, 1, 0}, {0, 0, -1}, {-1, 0, 0}}}}) {
    VolumeGeometry grid = test::grid({50, 50, 20}, {0.8, 0.8, 2});
    grid.direction = direction;
    useGrid(grid);
    const Transform patientFromIndex = grid.patientFromIndex();
    const Vec3 center = patientFromIndex * Vec3{24, 22, 10};
    std::vector<Contour> contours = ball({19.2, 17.6, 20}, 12, everyStep(0, 38, 2));
    for (Contour& contour : contours)
      for (Vec3& p : contour) p = patientFromIndex * Vec3{p.x / 0.8, p.y / 0.8, p.z / 2};
    const auto result = read({{"Gland", contours}});
    EXPECT_GT(diceWith(result.labels, kGland, [&](Vec3 p) { return norm(p - center) < 12; }), 0.995);
    EXPECT_THAT(result.notes, Not(Contains(HasSubstr("parallel"))));
  }
}

TEST_F(StructureSets, ContoursThatAreNotParallelToTheSlicesAreResampled) {
  VolumeGeometry grid = test::grid({60, 60, 60}, {0.8, 0.8, 0.8});
  grid.direction = test::obliqueDirection();
  grid.origin_mm = grid.direction * Vec3{-24, -24, -24};
  useGrid(grid);
  const auto result = read({{"Gland", ball({1, 2, 0}, 14, everyStep(-14, 14, 1))}});
  EXPECT_GT(diceWith(result.labels, kGland, [](Vec3 p) { return norm(p - Vec3{1, 2, 0}) < 14; }), 0.97);
  EXPECT_THAT(result.notes, Contains(HasSubstr("not parallel to the slices of the CT")));
}

TEST_F(StructureSets, ContoursInNoCommonDirectionAreLeftOut) {
  Contour upright = circle({}, 6);
  for (Vec3& p : upright) p = {p.x, 0, p.y};
  const auto result = read({{"Bone", {circle({}, 6), upright}}, {"Vein", {circle({10, 0, 0}, 4)}}});
  EXPECT_EQ(std::ranges::count(result.labels.voxels, kBone), 0);
  EXPECT_GT(std::ranges::count(result.labels.voxels, kVein), 0);
  EXPECT_THAT(result.notes, Contains(HasSubstr("\"Bone\" was left out: its contours do not lie in parallel planes")));
  EXPECT_EQ(result.structures[0].state, StructureState::kEmpty);
}

TEST_F(StructureSets, AreListedForAChoice) {
  test::writeStructureSet(file,
                          {{"Jug\xe9n", {circle({}, 6), circle({0, 0, 1}, 6)}},
                           {"Isocenter", {{Vec3{0, 0, 0}}}, "ISOCENTER", "POINT"},
                           {"Empty", {}}},
                          [](DataSet& data) { test::setText(data, Tag(0x0008, 0x0005), VR::CS, "ISO_IR 100"); });
  const auto result = importLabels(patient, file);
  ASSERT_TRUE(result) << result.error().message;
  const auto& list = result->structures;
  ASSERT_EQ(list.size(), 3U);
  EXPECT_EQ(list[0].name, "Jug\u00e9n");
  EXPECT_EQ(list[0].details, "organ, drawn by hand, 2 contours");
  EXPECT_EQ(list[0].state, StructureState::kTaken);
  EXPECT_EQ(list[1].details, "isocenter, drawn by hand, 0 contours");
  for (const int empty : {1, 2}) EXPECT_EQ(list[empty].state, StructureState::kEmpty);
  EXPECT_EQ(result->own.size(), 1U) << "structures without voxels need no label";
}

TEST_F(StructureSets, ChosenStructuresAreRead) {
  const std::vector<test::SentStructure> sent{{"Vein", {circle({-10, 0, 0}, 5)}}, {"Artery", {circle({10, 0, 0}, 5)}}};
  const auto one = read(sent, {.only = {"2"}});
  EXPECT_EQ(std::ranges::count(one.labels.voxels, kVein), 0);
  EXPECT_GT(std::ranges::count(one.labels.voxels, kArtery), 0);
  ASSERT_EQ(one.structures.size(), 2U) << "the list keeps what was left out";
  EXPECT_EQ(one.structures[0].state, StructureState::kLeftOut);
  EXPECT_EQ(one.structures[1].state, StructureState::kTaken);
  const auto rest = read(sent, {.taken = {{"Artery", false}}});
  EXPECT_GT(std::ranges::count(rest.labels.voxels, kVein), 0);
  EXPECT_EQ(std::ranges::count(rest.labels.voxels, kArtery), 0);
  EXPECT_EQ(rest.structures[1].state, StructureState::kLeftOut);
}

/// A planning system's names, two of them for the two sides of one label.
TEST_F(StructureSets, VesselsGetTheirNamesAndSides) {
  const auto result = read({{"V. jugularis interna re", ball({-14, 0, 0}, 6, everyStep(-6, 6, 1))},
                            {"IJV_L", ball({14, 0, 0}, 6, everyStep(-6, 6, 1))},
                            {"ACC", ball({18, 10, 0}, 3, everyStep(-3, 3, 1))}});
  ASSERT_EQ(result.structures.size(), 3U);
  EXPECT_EQ(result.structures[0].vessel, "right internal jugular vein");
  EXPECT_EQ(result.structures[1].vessel, "left internal jugular vein");
  EXPECT_EQ(result.structures[2].vessel, "left common carotid artery");
  const auto partAt = [&](double x) {
    const auto [i, j, k] = nearestVoxel(result.labels.geometry.indexFromPatient() * Vec3{x, 0, 0});
    return result.parts.at(i, j, k);
  };
  EXPECT_EQ(partAt(-14), 1);
  EXPECT_EQ(partAt(14), 2);
}

TEST_F(StructureSets, VolumesOfAPlanAreReadOnlyIfChosen) {
  const std::vector<test::SentStructure> sent{{"Vein", {circle({}, 5)}}, {"Boost", {circle({9, 0, 0}, 8)}, "PTV"}};
  const auto result = read(sent);
  EXPECT_EQ(result.structures[1].state, StructureState::kLeftOut);
  EXPECT_EQ(result.structures[1].details, "PTV, drawn by hand, 1 contour");
  EXPECT_TRUE(result.own.empty());
  EXPECT_EQ(read(sent, {.taken = {{"Boost", true}}}).structures[1].state, StructureState::kTaken);
}

/// A target volume may be drawn as an organ.
TEST_F(StructureSets, UnknownStructuresDoNotHideVessels) {
  const std::vector<test::SentStructure> sent{{"Vein", {circle({}, 5)}}, {"PTV 70", {circle({}, 15)}}};
  const auto veinIn = [](const LabelReadResult& result) { return std::ranges::count(result.labels.voxels, kVein); };
  const auto result = read(sent);
  EXPECT_NEAR(double(veinIn(result)) * 0.49, std::numbers::pi * 25, 3);
  EXPECT_EQ(veinIn(read(sent, {.taken = {{"PTV 70", true}}})), 0) << "the author asked for it";
}

/// Names of planning systems may contain the patient's name.
TEST_F(StructureSets, UnknownStructuresBecomeLabelsWithoutNames) {
  const auto result =
      read({{"PTV Miller", {circle({-10, 0, 0}, 5)}}, {"V. jugularis int. links", {circle({10, 0, 0}, 5)}}});
  ASSERT_EQ(result.own.size(), 1U);
  EXPECT_EQ(result.own.begin()->second.name, "");
  EXPECT_GT(std::ranges::count(result.labels.voxels, result.own.begin()->first), 0);
  EXPECT_GT(std::ranges::count(result.labels.voxels, kVein), 0);
  EXPECT_EQ(result.colors.at(result.own.begin()->first), (LabelColor{10, 200, 30}));
}

TEST_F(StructureSets, TheOutlineOfTheBodyLiesBelowAll) {
  const auto result = read({{"Vein", {circle({-2, 0, 0}, 6)}},
                            {"Artery", {circle({2, 0, 0}, 6)}},
                            {"Ring", {circle({}, 20)}, "EXTERNAL"},
                            {"Body", {circle({}, 20)}, "EXTERNAL"}},
                           {.taken = {{"Ring", true}}});
  const auto at = [&](double x) {
    return sampleNearest(result.labels, result.labels.geometry.indexFromPatient() * Vec3{x, 0, 0});
  };
  EXPECT_EQ(at(-6), kVein);
  EXPECT_EQ(at(0), kVein) << "the table gives veins the higher priority";
  EXPECT_EQ(at(15), result.own.begin()->first);
  EXPECT_EQ(result.structures[3].state, StructureState::kLeftOut) << "a body has no tissue of its own";
  const auto overlap = std::ranges::find_if(
      result.notes, [](const std::string& note) { return note.find("belong to several structures") != note.npos; });
  ASSERT_NE(overlap, result.notes.end());
  const double both = 2 * (36 * std::acos(1.0 / 3) - 2 * std::sqrt(32.0));  // two circles of 6 mm, 4 mm apart
  EXPECT_NEAR(std::stod(*overlap), both / 0.49, 8);
}

TEST_F(StructureSets, PointsAndEmptyContoursAreLeftOutAndSaid) {
  const auto result = read({{"Vein", {circle({}, 5), {}, {Vec3{1, 1, 3}}}},
                            {"Marker", {{Vec3{0, 0, 0}}}, "MARKER", "POINT"},
                            {"Line", {circle({0, 0, 2}, 3)}, "ORGAN", "OPEN_PLANAR"}});
  EXPECT_THAT(result.notes,
              Contains(HasSubstr("In the structure \"Vein\", 2 contours of fewer than three points were left")));
  EXPECT_THAT(result.notes, Contains(HasSubstr("\"Marker\" has no closed contours and was left out")));
  EXPECT_THAT(result.notes, Contains(HasSubstr("\"Line\" has no closed contours")));
  EXPECT_EQ(result.structures.size(), 3U);
  EXPECT_THAT(refusal({{"Vein", {{}}}}), HasSubstr("no closed contours"));
  EXPECT_THAT(refusal({{"Vein", {{Vec3{0, 0, 0}}}, "ORGAN", "POINT"}}), HasSubstr("no closed contours"));
}

TEST_F(StructureSets, ContoursOutsideTheCtAreRefusedOrSaid) {
  EXPECT_THAT(refusal({{"Vein", ball({500, 0, 0}, 8, everyStep(-8, 8, 1))}}), HasSubstr("another CT"));
  EXPECT_THAT(refusal({{"Vein", ball({0, 0, 500}, 8, everyStep(492, 508, 1))}}), HasSubstr("another CT"));
  const auto result = read({{"Vein", {circle({0, 0, 18}, 5), circle({0, 0, 19}, 5), circle({0, 0, 25}, 5)}}});
  EXPECT_THAT(result.notes, Contains("1 contour lies outside the CT and had no effect."));
}

TEST_F(StructureSets, AnotherSeriesIsSaid) {
  patient.manifest.source = "Imported from a DICOM CT series of 5 slices; its UID was replaced by 2.25.1.";
  test::writeStructureSet(file, {{"Vein", {circle({}, 5)}}}, [](DataSet& data) {
    DataSet series, study, frame;
    test::setText(series, Tag(0x0020, 0x000e), VR::UI, "1.2.3.4");
    test::setSequence(study, Tag(0x3006, 0x0014), {series});
    test::setSequence(frame, Tag(0x3006, 0x0012), {study});
    test::setSequence(data, Tag(0x3006, 0x0010), {frame});
  });
  const auto result = importLabels(patient, file);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_THAT(result->notes, Contains(HasSubstr("drawn on another DICOM series")));
}

TEST_F(StructureSets, DamagedContoursAreRefused) {
  const Tag data(0x3006, 0x0050), count(0x3006, 0x0046);
  EXPECT_THAT(refusalOf(data, VR::DS, "0\\0\\0\\1\\0\\0\\1\\1"),
              HasSubstr("\"Vein\" has a contour whose coordinates do not come in threes"));
  EXPECT_THAT(refusalOf(data, VR::DS, "0\\0\\0\\1\\nan\\0\\1\\1\\0"), HasSubstr("not numbers"));
  EXPECT_THAT(refusalOf(data, VR::DS, "0\\0\\0\\1e300\\0\\0\\1\\1\\0\\2\\2\\0"), HasSubstr("should have 180"));
  EXPECT_THAT(refusalOf(count, VR::IS, "179"), HasSubstr("a contour of 180 points that should have 179"));
  EXPECT_THAT(refusal({{"Vein", {{Vec3{0, 0, 0}, {2e5, 0, 0}, {0, 5, 0}}}}}), HasSubstr("more than 100 m away"));
  EXPECT_TRUE(importLabels(patient, file, {{}, false, {.taken = {{"Vein", false}}}}))
      << "a structure that is left out may be damaged";
}

TEST_F(StructureSets, FilesWithoutStructuresAreRefused) {
  const std::vector<test::SentStructure> vein{{"Vein", {circle({}, 5)}}};
  EXPECT_THAT(refusal(vein, [](DataSet& data) { data.Remove(Tag(0x3006, 0x0020)); }),
              HasSubstr("contains no structures"));
  EXPECT_THAT(refusal(vein, [](DataSet& data) { data.Remove(Tag(0x3006, 0x0039)); }), HasSubstr("no closed contours"));
  EXPECT_THAT(refusal({}), HasSubstr("contains no structures"));
  test::writeStructureSet(file, vein);
  const std::string whole = test::contentOf(file);
  for (std::size_t length = 140; length < whole.size(); length += 97) {
    test::writeText(file, whole.substr(0, length));
    EXPECT_FALSE(importLabels(patient, file)) << length;
  }
  test::writeText(file, "no DICOM");
  EXPECT_THAT(importLabels(patient, file).error().message, HasSubstr("contains no labels"));
}

TEST_F(StructureSets, AMillionPointsAreOneContour) {
  const auto result = read({{"Vein", {circle({}, 10, 1000000)}}});
  EXPECT_NEAR(volumeOf(result.labels, kVein), std::numbers::pi * 100, 3);
}

/// Each edge crosses all rows: memory must not grow with the crossings.
TEST_F(StructureSets, AZigzagOfManyPointsIsFilled) {
  Contour zigzag;
  for (int n = 0; n < 200001; ++n) zigzag.push_back({-20 + n * 2e-4, n % 2 ? 20.0 : -20.0, 0});
  EXPECT_GT(volumeOf(read({{"Vein", {zigzag}}, {"Artery", {circle({}, 5)}}}).labels, kArtery), 70);
}

TEST_F(StructureSets, StopWhenCancelled) {
  test::writeStructureSet(file, {{"Vein", {circle({}, 5)}}});
  const auto result = importLabels(patient, file, {}, [](std::string_view, double) { return false; });
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().message, kCancelled);
}

}  // namespace
}  // namespace insonate
