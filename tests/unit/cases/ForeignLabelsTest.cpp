#include "MaskFiles.h"
#include "files/LabelNames.h"
#include "structures/FoldedWords.h"
#include "structures/StructureTable.h"
#include "support/TestData.h"

#include <insonate/cases/LabelFile.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <array>

namespace insonate {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST(StructureTable, TheBuiltInTableIsRead) {
  EXPECT_GT(structureTable().structures.size(), 40U);
  EXPECT_GT(structureTable().priority.at(kVein), structureTable().priority.at(kArtery));
  EXPECT_GT(structureTable().priority.at(kArtery), structureTable().priority.at(kMuscle));
  EXPECT_THAT(readStructureTable(R"({"structures": [{"name": "a", "label": "heart"}]})").error().message,
              HasSubstr("unknown label 'heart'"));
  EXPECT_THAT(readStructureTable(R"({"structures": [{"name": "a"}, {"name": "b", "names": ["A"]}]})").error().message,
              HasSubstr("'a' of another structure"));
  EXPECT_FALSE(readStructureTable("{"));
}

TEST(StructureTable, ClassesOfTotalSegmentator) {
  const std::pair<Label, std::vector<const char*>> kExpected[] = {
      {kBone,
       {"sacrum", "vertebrae_S1", "vertebrae_L5", "vertebrae_T12", "vertebrae_C7", "humerus_left", "scapula_right",
        "clavicula_left", "femur_right", "hip_left", "skull", "rib_left_1", "rib_right_12", "sternum",
        "zygomatic_arch_left", "styloid_process_right", "hyoid", "hard_palate"}},
      {kMuscle,
       {"gluteus_maximus_left", "autochthon_right", "iliopsoas_left", "superior_pharyngeal_constrictor",
        "trapezius_right", "platysma_left", "levator_scapulae_right", "anterior_scalene_left",
        "posterior_scalene_right", "sterno_thyroid_left", "thyrohyoid_right", "prevertebral_left", "skeletal_muscle",
        "masseter_right", "tongue"}},
      {kSternocleidomastoid, {"sternocleidomastoid_right", "sternocleidomastoid_left"}},
      {kThyroid, {"thyroid_gland"}},
      {kCartilage, {"costal_cartilages", "thyroid_cartilage", "cricoid_cartilage"}},
      {kOesophagus, {"esophagus"}},
      {kAirway,
       {"trachea", "lung_upper_lobe_left", "lung_middle_lobe_right", "larynx_air", "nasopharynx", "nasal_cavity_left"}},
      {kFat, {"subcutaneous_fat", "torso_fat"}},
      {kSkin, {"skin"}},
      {kGland, {"parotid_gland_left", "submandibular_gland_right"}},
      {kVein,
       {"internal_jugular_vein_right", "brachiocephalic_vein_left", "superior_vena_cava", "inferior_vena_cava",
        "iliac_vena_left", "pulmonary_vein", "portal_vein_and_splenic_vein"}},
      {kArtery,
       {"aorta", "common_carotid_artery_left", "internal_carotid_artery_right", "subclavian_artery_left",
        "brachiocephalic_trunk", "iliac_artery_right"}}};
  for (const auto& [label, names] : kExpected)
    for (const char* name : names) {
      ASSERT_TRUE(structureOfName(name)) << name;
      EXPECT_EQ(labelFromAnyName(name), label) << name;
    }
  for (const char* name : {"spleen", "kidney_left", "adrenal_gland_right", "brain", "spinal_cord", "heart",
                           "atrial_appendage_left", "body_trunc", "body_extremities", "auditory_canal_left",
                           "soft_palate", "eye_lens_left", "optic_nerve_right", "kidney_cyst_left", "urinary_bladder"})
    EXPECT_TRUE(isLeftOut(name)) << name;
}

TEST(StructureTable, SidesAreReadInFiveLanguagesAndAsLetters) {
  for (const char* name : {"internal_jugular_vein_left", "left internal jugular vein", "V. jugularis interna links",
                           "VJI_L", "veine jugulaire interne gauche", "vena yugular interna izquierda",
                           "Internal-Jugular-Vein-L", "v jugularis interna sin.sinistra"}) {
    EXPECT_EQ(sideInName(name), BodySide::Left) << name;
    ASSERT_TRUE(structureOfName(name)) << name;
    EXPECT_EQ(structureOfName(name)->name, "internal jugular vein") << name;
  }
  EXPECT_EQ(structureOfName("ACC rechts")->name, "common carotid artery");
  EXPECT_EQ(structureOfName("A_Carotid_R")->name, "carotid artery");
  EXPECT_EQ(structureOfName("femoral vein right")->name, "common femoral vein");
  EXPECT_FALSE(structureOfName("A. profunda femoris dextra")) << "a branch";
  EXPECT_FALSE(sideInName("vertebrae_L1")) << "a lumbar vertebra";
  EXPECT_FALSE(sideInName("vein left of the right lobe"));
  EXPECT_EQ(nameWithoutSide("rib_left_4"), "rib");
}

/// A neck of rods, and a folder with masks of its structures. The vessels lie on the right side.
class ForeignLabels : public testing::Test {
 protected:
  ForeignLabels() : patient(test::cylinderNeck()), truth(patient.labels) {
    std::ranges::fill(patient.labels.voxels, kBackground);
    fs::create_directories(folder / "seg");
  }
  void write(const std::string& name, const LabelMap& mask) { test::writeNiftiMask(folder / "seg" / name, mask); }
  void write(const std::string& name, std::uint8_t label) { write(name, test::maskOf(truth, label)); }
  LabelReadResult read(const NumberMeaning& meaning = {}) {
    auto result = importLabels(patient, folder / "seg", meaning);
    EXPECT_TRUE(result) << result.error().message;
    return result ? std::move(*result) : LabelReadResult{};
  }
  std::string refusal() { return importLabels(patient, folder / "seg").error().message; }
  static const ReadStructure& named(const LabelReadResult& read, const std::string& name) {
    const auto found = std::ranges::find(read.structures, name, &ReadStructure::name);
    EXPECT_NE(found, read.structures.end()) << name;
    return found == read.structures.end() ? read.structures.front() : *found;
  }
  static double dice(const LabelMap& a, const LabelMap& b, std::uint8_t label) {
    std::size_t both = 0, sum = 0;
    for (std::size_t v = 0; v < a.voxels.size(); ++v) {
      both += a.voxels[v] == label && b.voxels[v] == label;
      sum += std::size_t(a.voxels[v] == label) + std::size_t(b.voxels[v] == label);
    }
    return 2.0 * double(both) / double(sum);
  }

  test::TemporaryFolder folder;
  PatientCase patient;
  LabelMap truth;
};

TEST_F(ForeignLabels, AFolderOfMasks) {
  write("internal_jugular_vein_right.nii", kVein);
  write("common_carotid_artery_right.nii", kArtery);
  write("trachea.nii", kAirway);
  write("vertebrae_C5.nii", kBone);
  write("spleen.nii", kMuscle);
  const LabelReadResult result = read();
  for (const std::uint8_t label : {kVein, kArtery, kAirway, kBone})
    EXPECT_EQ(dice(result.labels, truth, label), 1) << int(label);
  EXPECT_EQ(std::ranges::count(result.labels.voxels, kMuscle), 0);
  EXPECT_EQ(named(result, "internal_jugular_vein_right").vessel, "right internal jugular vein");
  EXPECT_EQ(named(result, "common_carotid_artery_right").vessel, "right common carotid artery");
  EXPECT_EQ(named(result, "spleen").state, StructureState::kLeftOut);
  EXPECT_EQ(named(result, "internal_jugular_vein_right").voxels, std::size_t(std::ranges::count(truth.voxels, kVein)));
  EXPECT_THAT(result.notes, Contains(HasSubstr("left out: spleen")));
  EXPECT_THAT(result.own, IsEmpty());
  const auto vein = std::ranges::find(result.labels.voxels, kVein) - result.labels.voxels.begin();
  EXPECT_EQ(result.structures[result.parts.voxels[std::size_t(vein)] - 1].name, "internal_jugular_vein_right");
}

TEST_F(ForeignLabels, AMaskWithReversedAxesKeepsItsVoxels) {
  LabelMap turned(truth.geometry);
  turned.geometry.direction.column[0] = {-1, 0, 0};
  turned.geometry.direction.column[1] = {0, -1, 0};
  turned.geometry.origin_mm = {60, 60, -30};
  for (int k = 0; k < 61; ++k)
    for (int j = 0; j < 121; ++j)
      for (int i = 0; i < 121; ++i) turned.at(120 - i, 120 - j, k) = truth.at(i, j, k) == kVein;
  write("internal_jugular_vein_right.nii", turned);
  EXPECT_EQ(dice(read().labels, truth, kVein), 1);
}

TEST_F(ForeignLabels, MasksOnACoarserGridAreSmoothed) {
  const VolumeGeometry coarse = test::grid({81, 81, 41}, {1.5, 1.5, 1.5}, {-60, -60, -30});
  write("internal_jugular_vein_right.nii", test::rod(coarse, -30, -22, 7));
  write("vertebrae_C5.nii", test::rod(coarse, 0, 25, 12));
  const LabelReadResult result = read();
  EXPECT_GE(dice(result.labels, truth, kVein), 0.95);
  EXPECT_GE(dice(result.labels, truth, kBone), 0.95);
  EXPECT_THAT(result.notes, Contains(HasSubstr("linear interpolation")));
}

TEST_F(ForeignLabels, ThinStructuresHavePrecedence) {
  write("autochthon_right.nii", test::rod(truth.geometry, -25, -20, 30));
  write("internal_jugular_vein_right.nii", kVein);
  write("thyroid_gland.nii", test::rod(truth.geometry, -30, -22, 9));
  const LabelReadResult result = read();
  EXPECT_EQ(dice(result.labels, truth, kVein), 1);
  EXPECT_GT(std::ranges::count(result.labels.voxels, kThyroid), 0);
  EXPECT_THAT(result.notes, Contains(HasSubstr("belong to several structures")));
}

TEST_F(ForeignLabels, SeveralFoldersAndALabelMapOfOnePatient) {
  fs::create_directories(folder / "seg/total");
  fs::create_directories(folder / "seg/headneck_bones_vessels");
  write("total/trachea.nii", kAirway);
  write("headneck_bones_vessels/internal_jugular_vein_right.nii", kVein);
  LabelMap numbers(truth.geometry);
  for (std::size_t v = 0; v < numbers.voxels.size(); ++v)
    numbers.voxels[v] = truth.voxels[v] == kArtery ? 7 : truth.voxels[v] == kBone ? 9 : 0;
  test::writeNiftiMask(folder / "multi.nii", numbers,
                       test::labelTableOf({{7, "common_carotid_artery_right"}, {9, "vertebrae_C5"}, {1, "spleen"}}));
  const std::array<fs::path, 2> sources{folder / "seg", folder / "multi.nii"};
  const auto result = importLabelsTogether(patient, sources);
  ASSERT_TRUE(result) << result.error().message;
  for (const std::uint8_t label : {kVein, kArtery, kAirway, kBone})
    EXPECT_EQ(dice(result->labels, truth, label), 1) << int(label);
  EXPECT_THAT(result->notes, Contains(HasSubstr("the file's header")));
  EXPECT_THAT(missingForLines(result->structures),
              AllOf(Contains("The left internal jugular vein is missing. TotalSegmentator finds it with the task "
                             "headneck_bones_vessels."),
                    Contains("The thyroid gland is missing. TotalSegmentator finds it with the task total."),
                    Not(Contains(HasSubstr("groin")))));
}

TEST_F(ForeignLabels, OtherProgramsNameTheNumbersBesideTheMap) {
  LabelMap numbers(truth.geometry);
  for (std::size_t v = 0; v < numbers.voxels.size(); ++v) numbers.voxels[v] = truth.voxels[v] == kVein ? 3 : 0;
  write("map.nii", numbers);
  const std::pair<const char*, const char*> kFiles[] = {
      {"dataset.json",
       R"({"channel_names": {"0": "CT"}, "labels": {"background": 0, "internal_jugular_vein_right": 3}})"},
      {"metadata.json",
       R"({"version": "1", "network_data_format": {"outputs": {"pred": {"channel_def": {"0": "background", "3":
       "internal_jugular_vein_right"}}}}})"},
      {"label_dict.json", R"({"internal jugular vein right": 3, "spleen": 1})"},
      {"map.json", R"({"3": "IJV_R"})"}};
  for (const auto& [name, text] : kFiles) {
    test::writeText(folder / "seg" / name, text);
    for (const fs::path& source : {folder / "seg/map.nii", folder / "seg"}) {
      const auto result = importLabels(patient, source);
      ASSERT_TRUE(result) << name << ": " << result.error().message;
      EXPECT_EQ(dice(result->labels, truth, kVein), 1) << name;
      EXPECT_EQ(result->structures.at(0).vessel, "right internal jugular vein") << name;
    }
    fs::remove(folder / "seg" / name);
  }
  test::writeText(folder / "seg/metadata.json", R"({"version": 3, "task": "spleen"})");
  EXPECT_THAT(importLabels(patient, folder / "seg/map.nii").error().message, HasSubstr("does not say"));
}

TEST_F(ForeignLabels, ASideThatIsNotStatedIsThatOfTheLocation) {
  write("internal_jugular_vein.nii", kVein);
  const LabelReadResult result = read();
  EXPECT_EQ(result.structures.at(0).vessel, "right internal jugular vein");
  EXPECT_THAT(result.notes, Contains(HasSubstr("taken as the right one")));
}

TEST_F(ForeignLabels, ADoubtfulSideIsAsked) {
  write("internal_jugular_vein_left.nii", kVein);
  write("carotid_artery.nii", test::rod(truth.geometry, -4, -20, 3));
  LabelReadResult result = read();
  EXPECT_EQ(named(result, "internal_jugular_vein_left").state, StructureState::kDoubtful);
  EXPECT_THAT(named(result, "internal_jugular_vein_left").doubt, HasSubstr("states the left side, but"));
  EXPECT_EQ(named(result, "carotid_artery").state, StructureState::kDoubtful);
  EXPECT_THAT(named(result, "carotid_artery").doubt, HasSubstr("states no side"));
  EXPECT_EQ(named(result, "carotid_artery").vessel, "");

  NumberMeaning meaning;
  meaning.choices.sides = {{"internal_jugular_vein_left", SideAnswer::Left}, {"carotid_artery", SideAnswer::Both}};
  result = read(meaning);
  EXPECT_EQ(named(result, "internal_jugular_vein_left").vessel, "left internal jugular vein");
  EXPECT_EQ(named(result, "carotid_artery").vessel, "");
  for (const ReadStructure& structure : result.structures) EXPECT_EQ(structure.state, StructureState::kTaken);
}

TEST_F(ForeignLabels, TheAuthorChoosesStructures) {
  write("autochthon_right.nii", test::rod(truth.geometry, -30, -22, 12));
  write("internal_jugular_vein_right.nii", kVein);
  write("spleen.nii", test::rod(truth.geometry, 30, 0, 5));
  NumberMeaning meaning;
  meaning.choices.taken = {{"internal_jugular_vein_right", false}, {"spleen", true}};
  const LabelReadResult result = read(meaning);
  EXPECT_EQ(std::ranges::count(result.labels.voxels, kVein), 0);
  const std::size_t vein = patient.ct.geometry.offset(30, 38, 30);
  EXPECT_EQ(result.labels.voxels[vein], kMuscle) << "the muscle is below the vein that was left out";
  const std::uint8_t own = named(result, "spleen").label;
  ASSERT_TRUE(isOwnLabel(own));
  EXPECT_EQ(result.own.at(own), (OwnLabel{"spleen", kSoftTissue}));
}

TEST_F(ForeignLabels, SegmentsOf3DSlicerAreNamedAndChosen) {
  std::string voxels = test::bytesOf(truth.voxels);
  const std::string header =
      "type: unsigned char\ndimension: 3\nsizes: 121 121 61\nspace: left-posterior-superior\nspace directions: (1,0,0) "
      "(0,1,0) (0,0,1)\nspace origin: (-60,-60,-30)\n"
      "Segment0_ID:=a\nSegment0_Name:=ACC rechts\nSegment0_LabelValue:=2\nSegment0_Layer:=0\n"
      "Segment0_Tags:=TerminologyEntry:x~SCT^85756007^Tissue~SCT^69105007^Carotid artery~^^~Anatomic~^^~^^|\n"
      "Segment1_ID:=b\nSegment1_Name:=Vein 1\nSegment1_LabelValue:=6\nSegment1_Layer:=0\n"
      "Segment1_Tags:=TerminologyEntry:x~SCT^85756007^Tissue~SCT^12123001^Internal jugular vein~^^~Anatomic~^^~^^|\n";
  test::writeRawNrrd(folder / "a.seg.nrrd", header, voxels);
  auto result = importLabels(patient, folder / "a.seg.nrrd");
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->structures.at(0).vessel, "right common carotid artery");
  EXPECT_EQ(result->structures.at(1).vessel, "right internal jugular vein") << "by code and location";
  EXPECT_EQ(dice(result->labels, truth, kArtery), 1);
  NumberMeaning meaning;
  meaning.choices.taken["ACC rechts"] = false;
  result = importLabels(patient, folder / "a.seg.nrrd", meaning);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(std::ranges::count(result->labels.voxels, kArtery), 0);
  EXPECT_EQ(dice(result->labels, truth, kVein), 1);
}

TEST_F(ForeignLabels, TwoNamesOfOneVesselAreUnited) {
  write("internal_jugular_vein_right.nii", kVein);
  write("vena_jugularis_interna_rechts.nii", test::rod(truth.geometry, -30, -22, 4));
  const LabelReadResult result = read();
  EXPECT_EQ(dice(result.labels, truth, kVein), 1);
  EXPECT_THAT(result.notes, Contains(HasSubstr("each is the right internal jugular vein: internal_jugular")));
}

TEST_F(ForeignLabels, WhatIsNoMaskIsSaid) {
  write("internal_jugular_vein_right.nii", kVein);
  write("trachea.nii", LabelMap(truth.geometry));
  LabelMap ct(truth.geometry);
  for (std::size_t v = 0; v < ct.voxels.size(); ++v) ct.voxels[v] = static_cast<std::uint8_t>(v % 200);
  write("ct.nii", ct);
  VolumeGeometry elsewhere = truth.geometry;
  elsewhere.origin_mm = {900, 900, 900};
  write("aorta.nii", test::rod(elsewhere, 930, 930, 5));
  const LabelReadResult result = read();
  EXPECT_EQ(named(result, "trachea").state, StructureState::kEmpty);
  EXPECT_EQ(named(result, "aorta").state, StructureState::kEmpty);
  EXPECT_THAT(result.notes, Contains(HasSubstr("ct.nii is no mask")));
  EXPECT_THAT(result.notes, Contains(HasSubstr("lie outside the CT")));
  fs::remove(folder / "seg/internal_jugular_vein_right.nii");
  EXPECT_THAT(refusal(), HasSubstr("drawn on another CT"));
}

TEST_F(ForeignLabels, NamesOfStrangersAreNotStored) {
  write("Mr <b>Smith<!--b-->'s lump.nii", test::rod(truth.geometry, 30, 0, 5));
  const LabelReadResult result = read();
  const std::uint8_t own = result.structures.at(0).label;
  ASSERT_TRUE(isOwnLabel(own));
  EXPECT_EQ(result.own.at(own).name, "");
  PatientCase labeled = patient;
  replaceLabels(LabelReadResult(result), labeled);
  EXPECT_THAT(labeled.manifest.importNotes, Each(Not(HasSubstr("Smith"))));
}

TEST_F(ForeignLabels, DamagedFilesAreRefused) {
  EXPECT_THAT(refusal(), HasSubstr("contains no labels"));
  write("internal_jugular_vein_right.nii", kVein);
  std::string bytes = test::contentOf(folder / "seg/internal_jugular_vein_right.nii");
  test::writeText(folder / "seg/trachea.nii", bytes.substr(0, bytes.size() / 2));
  EXPECT_THAT(refusal(), AllOf(HasSubstr("trachea.nii"), HasSubstr("cut off or damaged")));
  const std::int16_t many = 1450;  // 3 GB
  for (int a = 0; a < 3; ++a) std::memcpy(bytes.data() + 42 + 2 * a, &many, sizeof many);
  test::writeText(folder / "seg/trachea.nii", bytes);
  EXPECT_THAT(refusal(), AllOf(HasSubstr("trachea.nii"), HasSubstr("cut off or damaged")));
  test::writeText(folder / "seg/trachea.nii", "text");
  EXPECT_THAT(refusal(), HasSubstr("not a NIfTI file"));
}

TEST_F(ForeignLabels, CancellingStops) {
  write("internal_jugular_vein_right.nii", kVein);
  const auto stopped = importLabels(patient, folder / "seg", {}, [](std::string_view, double) { return false; });
  EXPECT_EQ(stopped.error().message, kCancelled);
}

TEST(MissingForLines, EachRegionNeedsItsVessels) {
  ReadStructure hip{1, "hip_left", kBone, "bone of the hip"}, vein{2, "iliac_vena_left", kVein, "iliac vein"};
  vein.vessel = "left iliac vein";
  const std::array<ReadStructure, 2> groin{hip, vein};
  EXPECT_THAT(
      missingForLines(groin),
      testing::ElementsAre(
          "The iliac arteries are missing. TotalSegmentator finds them with the task total.",
          "The right iliac vein is missing. TotalSegmentator finds it with the task total.",
          "The common femoral veins are missing. No task of TotalSegmentator finds them; label them in Prepare.",
          "The common femoral arteries are missing. No task of TotalSegmentator finds them; label them in "
          "Prepare."));
  const std::array<ReadStructure, 1> unknown{ReadStructure{1, "vein", kVein}};
  EXPECT_THAT(missingForLines(unknown), IsEmpty());
}

}  // namespace
}  // namespace insonate
