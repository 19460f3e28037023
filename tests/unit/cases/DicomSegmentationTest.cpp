#include "SegmentationFiles.h"

#include <insonate/cases/Import.h>

#include <algorithm>

namespace insonate {
namespace {

namespace fs = std::filesystem;
using gdcm::DataSet;
using gdcm::Tag;
using gdcm::VR;
using test::bytesIn;
using test::DicomSegmentation;
using test::items;
using test::kFrames;
using test::kPixels;
using test::kSegments;
using test::kShared;
using test::setBytes;
using test::twoVessels;
using testing::Contains;
using testing::HasSubstr;

TEST_F(DicomSegmentation, ComesBackBitForBitOnAnyGrid) {
  VolumeGeometry oblique = test::grid({7, 5, 6}, {0.7, 0.9, 2.3}, {-123.4, 56.7, 8.9});
  oblique.direction = test::obliqueDirection();
  VolumeGeometry leftHanded = test::grid({9, 3, 4}, {1, 1, 3});
  leftHanded.direction.column[2] = {0, 0, -1};
  for (const VolumeGeometry& g : {oblique, leftHanded, test::grid({5, 7, 1})}) {
    write(test::noiseCase(g));
    const LabelReadResult back = read();
    EXPECT_EQ(back.labels.voxels, patient.labels.voxels);
    EXPECT_EQ(back.labels.geometry, g);
    EXPECT_THAT(back.colors, testing::IsEmpty());
    EXPECT_THAT(back.notes, testing::Each(testing::Not(HasSubstr("grid"))));
  }
}

TEST_F(DicomSegmentation, ColorsComeBack) {
  PatientCase made = twoVessels();
  for (int value = 0; value < 256; ++value) {
    made.colors = {{kVein, {static_cast<std::uint8_t>(value), static_cast<std::uint8_t>(255 - value), 77}},
                   {kArtery, {3, static_cast<std::uint8_t>(value), static_cast<std::uint8_t>(value / 2)}}};
    write(made);
    ASSERT_EQ(read().colors, made.colors) << value;
  }
}

TEST_F(DicomSegmentation, EmptyFramesAreLeftOut) {
  write(twoVessels());
  gdcm::Reader reader;
  reader.SetFileName(file.c_str());
  ASSERT_TRUE(reader.Read());
  const DataSet& data = reader.GetFile().GetDataSet();
  EXPECT_EQ(bytesIn(data, Tag(0x0028, 0x0008)), "3 ");
  EXPECT_EQ(items(data, kFrames).size(), 3U);
  EXPECT_EQ(bytesIn(data, kPixels).size(), 3U * 8);
}

TEST_F(DicomSegmentation, ItRefersToTheSeriesOfItsCase) {
  write(twoVessels());
  ASSERT_TRUE(writeDicomSeries(patient.ct, folder / "ct", dicomIdentityOf(patient)));
  const auto imported = importSeries(folder / "ct");
  ASSERT_TRUE(imported) << imported.error().message;
  const std::string bytes = test::contentOf(file);
  EXPECT_THAT(bytes, HasSubstr(imported->series.uid));
  patient.manifest.source = imported->source;
  EXPECT_THAT(read().notes, testing::Each(testing::Not(HasSubstr("another DICOM series"))));
  patient.manifest.source = "Imported; its UID was replaced by 2.25.1.";
  EXPECT_THAT(read().notes, Contains(HasSubstr("another DICOM series")));
}

TEST_F(DicomSegmentation, FramesInReverseOrder) {
  write(twoVessels());
  editItems(kFrames, [](auto& frames) { std::ranges::reverse(frames); });
  test::editDicom(file, [](DataSet& data) {
    const std::string bits = bytesIn(data, kPixels);
    setBytes(data, kPixels, VR::OB, bits.substr(16, 8) + bits.substr(8, 8) + bits.substr(0, 8));
  });
  EXPECT_EQ(read().labels.voxels, patient.labels.voxels);
}

TEST_F(DicomSegmentation, FractionsAreInsideFromOneHalf) {
  write(twoVessels());
  test::editDicom(file, [](DataSet& data) {
    const std::string bits = bytesIn(data, kPixels);
    std::string shares;
    for (std::size_t n = 0; n < bits.size() * 8; ++n) shares += (bits[n / 8] >> (n % 8) & 1) ? '\x32' : '\x31';
    setBytes(data, kPixels, VR::OB, shares);
    test::setText(data, Tag(0x0062, 0x0001), VR::CS, "FRACTIONAL");
    test::setShort(data, Tag(0x0062, 0x000e), VR::US, 100);
    test::setShort(data, Tag(0x0028, 0x0100), VR::US, 8);
    test::setShort(data, Tag(0x0028, 0x0101), VR::US, 8);
    test::setShort(data, Tag(0x0028, 0x0102), VR::US, 7);
  });
  EXPECT_EQ(read().labels.voxels, patient.labels.voxels);
  EXPECT_THAT(read().notes, Contains(HasSubstr("fractions")));
}

TEST_F(DicomSegmentation, SlicesThatAreFarApartStayAsThickAsTheFileSays) {
  PatientCase made = twoVessels();
  made.labels.at(2, 3, 2) = made.labels.at(3, 3, 2) = 0;  // slices 1 and 3 are left
  write(made);
  const auto edit = [&](const std::function<void(DataSet&)>& change) {
    editItems(kShared, [&](auto& shared) {
      std::vector<DataSet> measures = items(shared[0], Tag(0x0028, 0x9110));
      change(measures[0]);
      test::setSequence(shared[0], Tag(0x0028, 0x9110), measures);
    });
  };
  edit([](DataSet& measures) { measures.Remove(Tag(0x0018, 0x0088)); });
  EXPECT_EQ(read().labels.voxels, patient.labels.voxels);
  // Frames that lie closer than the file says are believed.
  write(twoVessels());
  edit([](DataSet& measures) { test::setText(measures, Tag(0x0018, 0x0088), VR::DS, "4"); });
  EXPECT_EQ(read().labels.voxels, patient.labels.voxels);
}

TEST_F(DicomSegmentation, TheLaterOfOverlappingSegmentsWinsAndThatIsSaid) {
  write(twoVessels());
  // The artery's frame to where the vein has two pixels; the artery is number 1.
  editItems(kFrames, [](auto& frames) { frames[0].Replace(frames[2].GetDataElement(Tag(0x0020, 0x9113))); });
  test::editDicom(file, [](DataSet& data) {
    std::string bits = bytesIn(data, kPixels);
    std::copy_n(bits.begin() + 16, 8, bits.begin());
    setBytes(data, kPixels, VR::OB, bits);
  });
  const LabelReadResult back = read();
  EXPECT_EQ(back.labels.at(2, 3, 2), kVein);
  EXPECT_THAT(back.notes, Contains(HasSubstr("2 voxels belong to several segments")));
}

TEST_F(DicomSegmentation, NamesWhereTheCodeIsAnotherSchemes) {
  write(twoVessels());
  editItems(kSegments, [](auto& segments) {
    for (DataSet& segment : segments) {
      DataSet code;
      test::setText(code, Tag(0x0008, 0x0100), VR::SH, "T-48170");
      test::setText(code, Tag(0x0008, 0x0102), VR::SH, "SRT");
      test::setSequence(segment, Tag(0x0062, 0x000f), {code});
      test::setText(segment, Tag(0x0062, 0x0009), VR::LO, "of another program");
    }
    test::setText(segments[0], Tag(0x0062, 0x0005), VR::LO, "Thing");
    test::setText(segments[1], Tag(0x0062, 0x0005), VR::LO, "Left jugular vein");
  });
  const LabelReadResult back = read();
  EXPECT_EQ(back.labels.at(2, 3, 1), kVein);
  EXPECT_EQ(back.labels.at(5, 6, 3), kLabelCount);
  EXPECT_EQ(back.own, (OwnLabels{{kLabelCount, {"", kSoftTissue}}})) << "kept apart, without a name that may identify";
  EXPECT_THAT(back.notes, Contains(HasSubstr("\"Thing\" (number 1) is a structure that Insonate does not know")));
}

TEST_F(DicomSegmentation, LabelsOfTheAuthorsOwnKeepNameAndTissue) {
  PatientCase made = twoVessels();
  made.labels.at(1, 1, 1) = 40, made.labels.at(1, 2, 1) = 200, made.labels.at(1, 3, 1) = 201;
  made.manifest.ownLabels = {{40, {"Vena jugularis externa, Äste", kVein}}, {200, {"", kSoftTissue}}};
  made.colors = {{40, {1, 2, 3}}};
  write(made);
  const LabelReadResult back = read();
  // DICOM numbers segments by itself; what has no name but its number keeps that.
  EXPECT_EQ(back.own, (OwnLabels{{16, {"Vena jugularis externa, Äste", kVein}}, {200, {"", kSoftTissue}}}))
      << "and nobody said what 201 is";
  EXPECT_EQ(back.labels.at(1, 1, 1), 16);
  EXPECT_EQ(back.labels.at(1, 2, 1), 200);
  EXPECT_EQ(back.labels.at(1, 3, 1), 201);
  EXPECT_EQ(back.labels.at(2, 3, 1), kVein) << "named as the table does";
  EXPECT_EQ(back.colors, (LabelColors{{16, {1, 2, 3}}}));
}

TEST_F(DicomSegmentation, TheCodeIsOfTheTissueAndTheNameTheAuthors) {
  PatientCase made = twoVessels();
  made.manifest.ownLabels = {{100, {"left clavicle", kBone}}};
  made.labels.at(1, 1, 1) = 100;
  write(made);
  gdcm::Reader reader;
  reader.SetFileName(file.c_str());
  ASSERT_TRUE(reader.Read());
  const DataSet segment = items(reader.GetFile().GetDataSet(), kSegments).back();
  EXPECT_EQ(bytesIn(segment, Tag(0x0062, 0x0005)), "left clavicle ");
  EXPECT_EQ(bytesIn(items(segment, Tag(0x0062, 0x000f)).front(), Tag(0x0008, 0x0100)), "272673000 ");
}

TEST_F(DicomSegmentation, OnAnotherGridEachVoxelTakesThePixelItLiesIn) {
  write(twoVessels());
  // Twice as fine, and only a part.
  patient.ct = CtVolume(test::grid({8, 8, 8}, {0.25, 0.375, 1}, {10.9, -18.1, 28}), 0);
  const LabelReadResult back = read();
  for (int k = 0; k < 8; ++k)
    for (int j = 0; j < 8; ++j)
      for (int i = 0; i < 8; ++i) {
        const Vec3 p = back.labels.geometry.patientFromIndex() * Vec3{double(i), double(j), double(k)};
        const Vec3 index = twoVessels().labels.geometry.indexFromPatient() * p;
        if (std::abs(index.z - std::floor(index.z) - 0.5) < 1e-6) continue;  // between two slices
        ASSERT_EQ(back.labels.at(i, j, k), sampleNearest(twoVessels().labels, index)) << i << ' ' << j << ' ' << k;
      }
  EXPECT_THAT(back.notes, Contains(HasSubstr("on another grid")));
  EXPECT_THAT(back.notes, Contains(HasSubstr("1 labeled voxels lie outside the CT")));
}

TEST_F(DicomSegmentation, ThatOfAnotherPlaceIsRefused) {
  write(twoVessels());
  patient.ct.geometry.origin_mm.z += 500;
  EXPECT_THAT(refusal(), testing::AllOf(HasSubstr("labels.dcm"), HasSubstr("drawn on another CT")));
}

TEST_F(DicomSegmentation, EveryCutIsRefused) {
  write(twoVessels());
  const std::string whole = test::contentOf(file);
  for (std::size_t length = 0; length < whole.size(); length += 7) {
    test::writeText(file, whole.substr(0, length));
    ASSERT_FALSE(importLabels(patient, file)) << "cut at " << length << " of " << whole.size();
  }
}

TEST_F(DicomSegmentation, ADamagedRepresentationInItsMetaInformationIsRefused) {
  write(twoVessels());
  std::string bytes = test::contentOf(file);
  const std::size_t first = bytes.find("UI", 132);
  ASSERT_LT(first, 250U);
  bytes[first + 1] = 'D';
  test::writeText(file, bytes);
  EXPECT_THAT(refusal(), HasSubstr("not a complete DICOM file"));
  EXPECT_FALSE(importSeries(file));
}

TEST_F(DicomSegmentation, WhatItLacksIsNamed) {
  const auto refusalAfter = [&](const std::function<void()>& damage) {
    write(twoVessels());
    damage();
    return refusal();
  };
  const auto edit = [&](const std::function<void(DataSet&)>& change) { test::editDicom(file, change); };
  EXPECT_THAT(refusalAfter([&] { edit([](DataSet& d) { setBytes(d, kPixels, VR::OB, "1234567890"); }); }),
              HasSubstr("fewer pixels"));
  EXPECT_THAT(refusalAfter([&] { edit([](DataSet& d) { test::setText(d, Tag(0x0028, 0x0008), VR::IS, "9"); }); }),
              HasSubstr("each of its 9 frames"));
  EXPECT_THAT(refusalAfter([&] { edit([](DataSet& d) { test::setShort(d, Tag(0x0028, 0x0010), VR::US, 0); }); }),
              HasSubstr("frames"));
  EXPECT_THAT(refusalAfter([&] { edit([](DataSet& d) { d.Remove(kShared); }); }), HasSubstr("where its frame 1 lies"));
  EXPECT_THAT(refusalAfter([&] {
                editItems(kSegments, [](auto& all) {
                  all.pop_back();
                  all.push_back(all[0]);
                });
              }),
              HasSubstr("does not describe the segment"));
  for (const char* type : {"LABELMAP", "ANOTHER"})
    EXPECT_THAT(refusalAfter([&] { edit([&](DataSet& d) { test::setText(d, Tag(0x0062, 0x0001), VR::CS, type); }); }),
                HasSubstr(std::string(type) + ", 1 bits"));
  EXPECT_THAT(refusalAfter([&] {
                edit([](DataSet& d) { test::setText(d, Tag(0x0008, 0x0016), VR::UI, "1.2.840.10008.5.1.4.1.1.2"); });
              }),
              HasSubstr("is a DICOM file, but not a segmentation"));
}

TEST_F(DicomSegmentation, NothingLabeledIsNotWritten) {
  PatientCase empty = twoVessels();
  std::ranges::fill(empty.labels.voxels, std::uint8_t{0});
  EXPECT_THAT(writeDicomSegmentation(empty, file).error().message, HasSubstr("Nothing is labeled"));
  EXPECT_FALSE(fs::exists(file));
  const auto stop = [](std::string_view, double) { return false; };
  EXPECT_EQ(writeDicomSegmentation(twoVessels(), file, stop).error().message, kCancelled);
  EXPECT_FALSE(fs::exists(file));
}

TEST_F(DicomSegmentation, PassesTheStandardsChecker) {
  if (std::system("command -v dciodvfy >/dev/null") != 0) GTEST_SKIP() << "dciodvfy (dicom3tools) is not installed";
  write(test::noiseCase(test::grid({7, 5, 6}, {0.7, 0.9, 2.3})));
  const fs::path report = folder / "report";
  ASSERT_EQ(std::system(("dciodvfy '" + file.string() + "' 2>'" + report.string() + "'").c_str()), 0);
  EXPECT_THAT(test::contentOf(report), testing::AllOf(HasSubstr("Segmentation"), testing::Not(HasSubstr("Error"))));
}

TEST(RealSegmentation, AgreesWithItsTwin) {
  INSONATE_NEEDS_DATA("seg-dicom");
  const auto ct = importSeries(test::testData("seg-dicom/ct-3slice"));
  ASSERT_TRUE(ct) << ct.error().message;
  PatientCase patient{{}, ct->ct, LabelMap(ct->ct.geometry)};
  patient.manifest.source = ct->source;
  const auto labels = importLabels(patient, test::testData("seg-dicom/liver.dcm"));
  ASSERT_TRUE(labels) << labels.error().message;
  EXPECT_THAT(labels->notes,
              testing::ElementsAre(HasSubstr("\"Liver\" (number 1) is a structure that Insonate does not know")));
  const auto twin = readLabelValues(test::testData("seg-dicom/liver_seg.nrrd"));
  ASSERT_TRUE(twin) << twin.error().message;
  ASSERT_TRUE(sameGrid(twin->geometry, patient.ct.geometry));
  std::size_t inside = 0;
  for (std::size_t v = 0; v < twin->voxels.size(); ++v) {
    ASSERT_EQ(labels->labels.voxels[v] != 0, twin->voxels[v] != 0) << "voxel " << v;
    inside += twin->voxels[v] != 0;
  }
  EXPECT_GT(inside, 1000U);
}

}  // namespace
}  // namespace insonate
