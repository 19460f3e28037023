#include "CaseSamples.h"
#include "DicomFiles.h"
#include "support/TestData.h"

#include <insonate/cases/CaseStatistics.h>
#include <insonate/cases/DicomWriter.h>
#include <insonate/cases/Import.h>

#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

namespace fs = std::filesystem;
using gdcm::DataSet;
using gdcm::Tag;
using gdcm::VR;
using testing::HasSubstr;

class DicomImport : public testing::Test {
 protected:
  void write(const CtVolume& volume, const std::string& seed = "seed") {
    ct = volume;
    const auto written = writeDicomSeries(ct, series, {.seed = seed, .description = "test"});
    ASSERT_TRUE(written) << written.error().message;
  }
  std::vector<fs::path> files() const {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(series)) found.push_back(entry.path());
    std::ranges::sort(found);
    return found;
  }
  ImportedCt imported() {
    auto result = importSeries(series);
    EXPECT_TRUE(result) << result.error().message;
    return result ? std::move(*result) : ImportedCt{};
  }
  std::string refusal() {
    const auto result = importSeries(series);
    EXPECT_FALSE(result);
    return result ? "" : result.error().message;
  }
  test::TemporaryFolder folder;
  const fs::path series = folder / "series";
  CtVolume ct;
};

TEST_F(DicomImport, PhantomSeriesComesBackExactly) {
  write(test::noiseCt(test::grid({20, 14, 9}, {0.7, 0.9, 1.4}, {-123.45, 67.8, -159.6})));
  const ImportedCt back = imported();
  EXPECT_EQ(back.ct.geometry, ct.geometry);
  EXPECT_EQ(back.ct.voxels, ct.voxels);
  EXPECT_THAT(back.series.warnings, testing::IsEmpty());
  EXPECT_EQ(back.series.modality, "CT");
}

TEST_F(DicomImport, ObliqueSeriesComesBack) {
  VolumeGeometry g = test::grid({12, 10, 6}, {0.8, 0.8, 2.5}, {10, 20, 30});
  g.direction = test::obliqueDirection();
  write(test::noiseCt(g));
  const ImportedCt back = imported();
  EXPECT_EQ(back.ct.voxels, ct.voxels);
  EXPECT_TRUE(sameGrid(back.ct.geometry, g));
  EXPECT_THAT(back.series.warnings, testing::IsEmpty()) << "rounding is no tilt";
}

TEST_F(DicomImport, LeftHandedSeriesKeepsEveryVoxelInItsPlace) {
  VolumeGeometry g = test::grid({6, 5, 4}, {1, 1, 2}, {0, 0, 100});
  g.direction.column[2] = {0, 0, -1};
  write(test::noiseCt(g));
  const ImportedCt back = imported();
  EXPECT_GT(determinant(back.ct.geometry.direction), 0);
  for (int k = 0; k < 4; ++k) {
    const Vec3 place = g.patientFromIndex() * Vec3{2, 3, double(k)};
    const Vec3 index = back.ct.geometry.indexFromPatient() * place;
    EXPECT_EQ(back.ct.at(2, 3, static_cast<int>(std::lround(index.z))), ct.at(2, 3, k));
  }
}

TEST_F(DicomImport, SameSeedSameBytesOtherSeedOtherUids) {
  write(test::noiseCt(test::grid({4, 4, 2})));
  ASSERT_TRUE(writeDicomSeries(ct, folder / "again", {.seed = "seed", .description = "test"}));
  ASSERT_TRUE(writeDicomSeries(ct, folder / "other", {.seed = "other", .description = "test"}));
  const std::string a = test::contentOf(files()[0]), name = files()[0].filename().string();
  EXPECT_EQ(a, test::contentOf(folder / "again" / name));
  EXPECT_NE(a, test::contentOf(folder / "other" / name));
  EXPECT_EQ(a.substr(128, 4), "DICM");
}

/// Lets files be out of reach also for the administrator, whom no permission stops.
class AsNobody {
 public:
  AsNobody() {
    if (::geteuid() == 0) changed_ = ::seteuid(65534) == 0;
  }
  ~AsNobody() {
    if (changed_ && ::seteuid(0) != 0) ADD_FAILURE() << "not administrator again";
  }
  AsNobody(const AsNobody&) = delete;
  AsNobody& operator=(const AsNobody&) = delete;

 private:
  bool changed_ = false;
};

TEST_F(DicomImport, ASliceThatCannotBeOpenedIsNotLeftOutSilently) {
  write(test::noiseCt(test::grid({4, 4, 6})));
  for (const fs::path& place : {folder.path(), series}) fs::permissions(place, fs::perms(0755));
  for (const fs::path& file : files()) fs::permissions(file, fs::perms(0644));
  fs::permissions(files()[5], fs::perms::none);
  const AsNobody nobody;
  EXPECT_THAT(refusal(), testing::AllOf(HasSubstr("slice00006.dcm"), HasSubstr("Permission denied")));
  const auto listing = listSeries(series);
  ASSERT_TRUE(listing) << listing.error().message;
  ASSERT_EQ(listing->skippedFiles.size(), 1U);
  EXPECT_THAT(listing->skippedFiles[0].reason,
              testing::AllOf(HasSubstr("cannot be read"), HasSubstr("Permission denied")));
  EXPECT_THAT(listing->series.at(0).warnings, testing::Contains(HasSubstr("slices may be missing")));
  const auto chosen = importSeries(series, listing->series[0].uid);
  ASSERT_TRUE(chosen) << chosen.error().message;
  EXPECT_EQ(chosen->ct.geometry.size[2], 5);
  EXPECT_THAT(chosen->series.warnings, testing::Contains(HasSubstr("slices may be missing")));
  EXPECT_THAT(chosen->series.warnings, testing::Each(testing::Not(HasSubstr("slice00006")))) << "they go into the case";
  EXPECT_THAT(importSeries(files()[5]).error().message, HasSubstr("Permission denied"));
}

TEST_F(DicomImport, ALinkToNothingMayBeASlice) {
  write(test::noiseCt(test::grid({4, 4, 3})));
  fs::create_symlink(folder / "gone.dcm", series / "slice00004.dcm");
  EXPECT_THAT(refusal(), testing::AllOf(HasSubstr("slice00004.dcm"), HasSubstr("cannot be read")));
}

TEST_F(DicomImport, PixelsThatNoScannerMakesAreRefused) {
  write(test::noiseCt(test::grid({4, 4, 3})));
  for (const fs::path& file : files())
    test::editDicom(file, [](DataSet& data) { test::setText(data, Tag(0x0028, 0x0030), VR::DS, "0.001\\0.001"); });
  EXPECT_THAT(refusal(), testing::AllOf(HasSubstr("0.001 mm"), HasSubstr("meters?")));
  const auto listing = listSeries(series);
  ASSERT_TRUE(listing);
  EXPECT_FALSE(listing->series.at(0).geometryKnown);
  EXPECT_THAT(seriesListText(*listing), testing::Not(HasSubstr("1x1x1 mm")));
}

TEST_F(DicomImport, WriterRefusesAFullFolder) {
  write(test::noiseCt(test::grid({4, 4, 2})));
  EXPECT_THAT(writeDicomSeries(ct, series, {.seed = "x"}).error().message, HasSubstr("not empty"));
}

TEST_F(DicomImport, SlopeAndInterceptOfEachSlice) {
  CtVolume constant(test::grid({4, 4, 3}), 100);
  write(constant);
  for (int k = 0; k < 3; ++k)
    test::editDicom(files()[k], [&](DataSet& data) {
      test::setText(data, Tag(0x0028, 0x1053), VR::DS, k == 1 ? "0.5" : "2");
      test::setText(data, Tag(0x0028, 0x1052), VR::DS, std::to_string(-10 * k));
    });
  const ImportedCt back = imported();
  EXPECT_EQ(back.ct.at(1, 1, 0), 200);
  EXPECT_EQ(back.ct.at(1, 1, 1), 40);
  EXPECT_EQ(back.ct.at(1, 1, 2), 180);
}

TEST_F(DicomImport, PaddingBecomesAir) {
  CtVolume padded(test::grid({4, 4, 2}), 50);
  padded.at(0, 0, 0) = -3024;
  padded.at(1, 0, 0) = 1234;
  write(padded);
  test::editDicom(files()[0], [](DataSet& data) { test::setShort(data, Tag(0x0028, 0x0120), VR::SS, 1234); });
  const ImportedCt back = imported();
  EXPECT_EQ(back.ct.at(0, 0, 0), -1024);
  EXPECT_EQ(back.ct.at(1, 0, 0), -1024) << "Pixel Padding Value";
  EXPECT_EQ(back.ct.at(2, 0, 0), 50);
  EXPECT_THAT(back.series.warnings, testing::Contains(HasSubstr("2 voxels were padding")));
}

TEST_F(DicomImport, OutsideTheScannersCircleIsAirInEachResult) {
  const auto rim = [](int i, int j) { return std::hypot(i - 15.5, j - 15.5) > 15.5; };
  for (const int padding_HU : {-2000, -3024}) {
    SCOPED_TRACE(padding_HU);
    CtVolume padded(test::grid({32, 32, 6}, {1, 1, 2}), -1000);
    for (int k = 0; k < 6; ++k)
      for (int j = 0; j < 32; ++j)
        for (int i = 0; i < 32; ++i) {
          if (std::hypot(i - 15.5, j - 15.5) < 10) padded.at(i, j, k) = 40;
          if (rim(i, j)) padded.at(i, j, k) = std::int16_t(padding_HU);
        }
    fs::remove_all(series);
    write(padded);
    const ImportedCt back = imported();
    EXPECT_FALSE(back.likelyShift_HU) << "the values are no HU plus 1024";
    EXPECT_EQ(back.saturatedVoxels, 0U);
    for (int j = 0; j < 32; ++j)
      for (int i = 0; i < 32; ++i)
        if (rim(i, j))
          ASSERT_EQ(back.ct.at(i, j, 3), -1024);
        else
          ASSERT_EQ(back.ct.at(i, j, 3), padded.at(i, j, 3));
    PatientCase made{{}, back.ct, LabelMap(back.ct.geometry)};
    const auto statistics = caseStatistics(made);
    ASSERT_TRUE(statistics);
    EXPECT_EQ(statistics->min_HU, -1024);
    EXPECT_EQ(statistics->max_HU, 40);
  }
}

TEST_F(DicomImport, OverlayInHighBitsIsMasked) {
  CtVolume volume(test::grid({4, 4, 2}), 100);
  volume.at(1, 1, 0) = static_cast<std::int16_t>(100 | 0x4000);
  write(volume);
  for (const fs::path& file : files())
    test::editDicom(file, [](DataSet& data) {
      test::setShort(data, Tag(0x0028, 0x0101), VR::US, 12);
      test::setShort(data, Tag(0x0028, 0x0102), VR::US, 11);
    });
  EXPECT_EQ(imported().ct.at(1, 1, 0), 100);
}

TEST_F(DicomImport, MissingSliceIsNamed) {
  write(test::noiseCt(test::grid({6, 6, 8}, {1, 1, 2})));
  fs::remove(files()[3]);
  const ImportedCt back = imported();
  EXPECT_EQ(back.ct.geometry.size[2], 8);
  EXPECT_THAT(back.series.warnings, testing::ElementsAre(HasSubstr("1 slice is missing, at 6.0 mm")));
}

TEST_F(DicomImport, TruncatedPixelsAreRefused) {
  write(test::noiseCt(test::grid({16, 16, 4})));
  const std::string whole = test::contentOf(files()[2]);
  test::writeText(files()[2], whole.substr(0, whole.size() - 100));
  EXPECT_THAT(refusal(), testing::AllOf(HasSubstr("slice00003.dcm"), HasSubstr("cut off")));
}

TEST_F(DicomImport, PixelsFewerThanTheHeaderSaysAreRefused) {
  write(test::noiseCt(test::grid({16, 16, 3})));
  for (const fs::path& file : files())
    test::editDicom(file, [](DataSet& data) { test::setShort(data, Tag(0x0028, 0x0010), VR::US, 64); });
  EXPECT_THAT(refusal(), HasSubstr("cut off or damaged"));
}

TEST_F(DicomImport, InvertedPicturesAreRefused) {
  write(test::noiseCt(test::grid({6, 5, 2})));
  for (const auto& file : files())
    test::editDicom(file, [](DataSet& data) { test::setText(data, Tag(0x0028, 0x0004), VR::CS, "MONOCHROME1"); });
  EXPECT_THAT(refusal(), testing::AllOf(HasSubstr("MONOCHROME1"), HasSubstr("inverted")));
}

TEST_F(DicomImport, StrayFilesAreSetAsideWithAReason) {
  write(test::noiseCt(test::grid({6, 6, 3})));
  test::writeText(series / "notes.dcm", "not DICOM");
  test::writeText(series / "README", "text");
  fs::copy(files().back(), series / "scout");
  const auto stray = [&](const char* name, Tag tag, VR::VRType vr, const char* value) {
    fs::copy(series / "slice00001.dcm", series / name);
    test::editDicom(series / name, [&](DataSet& data) { test::setText(data, tag, vr, value); });
  };
  fs::remove(series / "scout");
  stray("scout", Tag(0x0008, 0x0008), VR::CS, "ORIGINAL\\PRIMARY\\LOCALIZER");
  stray("capture", Tag(0x0008, 0x0016), VR::UI, "1.2.840.10008.5.1.4.1.1.7");
  stray("seg", Tag(0x0008, 0x0016), VR::UI, "1.2.840.10008.5.1.4.1.1.66.4");
  stray("report", Tag(0x0008, 0x0016), VR::UI, "1.2.840.10008.5.1.4.1.1.88.11");
  const auto listing = listSeries(series);
  ASSERT_TRUE(listing) << listing.error().message;
  EXPECT_EQ(listing->series.size(), 1U);
  std::vector<std::string> reasons;
  for (const SkippedFile& s : listing->skippedFiles) reasons.push_back(s.file.filename().string() + ": " + s.reason);
  EXPECT_THAT(reasons, testing::UnorderedElementsAre(
                           "notes.dcm: named like DICOM, but not a DICOM file", "README: neither DICOM nor a volume",
                           HasSubstr("scout: a scout"), HasSubstr("capture: a secondary capture"),
                           HasSubstr("seg: a DICOM segmentation"), HasSubstr("report: a structured report")));
  EXPECT_EQ(imported().ct.voxels, ct.voxels);
}

TEST_F(DicomImport, SeveralSeriesAreListedNotGuessed) {
  write(test::noiseCt(test::grid({6, 6, 3})));
  ASSERT_TRUE(writeDicomSeries(test::noiseCt(test::grid({4, 4, 5})), series / "second", {.seed = "second"}));
  const auto listing = listSeries(series);
  ASSERT_TRUE(listing);
  ASSERT_EQ(listing->series.size(), 2U);
  EXPECT_THAT(refusal(), testing::AllOf(HasSubstr("2 series"), HasSubstr(listing->series[0].uid),
                                        HasSubstr(listing->series[1].uid)));
  for (const SeriesInfo& s : listing->series) {
    const auto one = importSeries(series, s.uid);
    ASSERT_TRUE(one) << one.error().message;
    EXPECT_EQ(one->ct.geometry, s.geometry);
  }
  EXPECT_THAT(importSeries(series, "1.2.3").error().message, HasSubstr("no series 1.2.3"));
}

TEST_F(DicomImport, ASliceThatIsChosenStandsForItsSeries) {
  write(test::noiseCt(test::grid({6, 6, 7}, {1, 1, 2})));
  const ImportedCt whole = imported();
  // Another series, a copy of the slice and something else in the same folder.
  ASSERT_TRUE(writeDicomSeries(test::noiseCt(test::grid({4, 4, 5})), folder / "other", {.seed = "other"}));
  const fs::path chosen = files()[3];
  for (const auto& entry : fs::directory_iterator(folder / "other"))
    fs::copy_file(entry.path(), series / ("other-" + entry.path().filename().string()));
  fs::copy_file(chosen, series / "copy.dcm");
  test::writeText(series / "readme.txt", "no slice");

  const auto one = importSeries(chosen);
  ASSERT_TRUE(one) << one.error().message;
  EXPECT_EQ(one->ct.geometry, whole.ct.geometry);
  EXPECT_EQ(one->ct.voxels, whole.ct.voxels);
  EXPECT_THAT(one->series.warnings, testing::IsEmpty());
  const auto listing = listSeries(chosen);
  ASSERT_TRUE(listing);
  EXPECT_EQ(listing->series.size(), 1U);

  fs::create_directory(folder / "alone");
  fs::copy_file(chosen, folder / "alone/slice.dcm");
  const auto alone = importSeries(folder / "alone/slice.dcm");
  ASSERT_TRUE(alone) << alone.error().message;
  EXPECT_EQ(alone->ct.geometry.size[2], 1) << "the folder has just that";
}

TEST_F(DicomImport, NothingIdentifyingEntersTheCase) {
  write(test::noiseCt(test::grid({6, 6, 3})));
  for (const fs::path& file : files())
    test::editDicom(file, [](DataSet& data) {
      test::setText(data, Tag(0x0010, 0x0010), VR::PN, "Doe^Jane");
      test::setText(data, Tag(0x0008, 0x103e), VR::LO, "Jane's neck");
    });
  const ImportedCt back = imported();
  EXPECT_THAT(back.source, testing::Not(HasSubstr(back.series.uid)));
  EXPECT_THAT(back.source, HasSubstr("2.25."));
  EXPECT_THAT(back.source, testing::Not(testing::ContainsRegex("Doe|Jane")));
  for (const std::string& w : back.series.warnings) EXPECT_THAT(w, testing::Not(testing::ContainsRegex("Doe|Jane")));
}

DataSet groupItem(Tag group, const std::function<void(DataSet&)>& fill) {
  DataSet content, item;
  fill(content);
  test::setSequence(item, group, {content});
  return item;
}

TEST_F(DicomImport, EnhancedMultiFrame) {
  write(test::noiseCt(test::grid({6, 5, 4}, {0.7, 0.9, 2}, {1, 2, 3})));
  // One file with all frames, stored top to bottom, its geometry inside functional groups.
  std::vector<std::int16_t> frames;
  std::vector<DataSet> perFrame;
  for (int k = 3; k >= 0; --k) {
    frames.insert(frames.end(), ct.voxels.begin() + k * 30, ct.voxels.begin() + (k + 1) * 30);
    perFrame.push_back(groupItem(Tag(0x0020, 0x9113), [&](DataSet& d) {
      test::setText(d, Tag(0x0020, 0x0032), VR::DS, "1\\2\\" + std::to_string(3 + 2 * k));
    }));
  }
  DataSet shared = groupItem(Tag(0x0020, 0x9116),
                             [](DataSet& d) { test::setText(d, Tag(0x0020, 0x0037), VR::DS, "1\\0\\0\\0\\1\\0"); });
  for (const auto& [group, fill] :
       {std::pair<Tag, std::function<void(DataSet&)>>{
            Tag(0x0028, 0x9110), [](DataSet& d) { test::setText(d, Tag(0x0028, 0x0030), VR::DS, "0.9\\0.7"); }},
        {Tag(0x0028, 0x9145), [](DataSet& d) {
           test::setText(d, Tag(0x0028, 0x1052), VR::DS, "-7");
           test::setText(d, Tag(0x0028, 0x1053), VR::DS, "1");
         }}}) {
    const DataSet item = groupItem(group, fill);
    shared.Replace(item.GetDataElement(group));
  }
  for (int n = 1; n < 4; ++n) fs::remove(files()[1]);
  test::editDicom(files()[0], [&](DataSet& data) {
    test::setText(data, Tag(0x0008, 0x0016), VR::UI, "1.2.840.10008.5.1.4.1.1.2.1");
    test::setText(data, Tag(0x0028, 0x0008), VR::IS, "4");
    for (const Tag& tag :
         {Tag(0x0020, 0x0032), Tag(0x0020, 0x0037), Tag(0x0028, 0x0030), Tag(0x0028, 0x1052), Tag(0x0028, 0x1053)})
      data.Remove(tag);
    test::setSequence(data, Tag(0x5200, 0x9229), {shared});
    test::setSequence(data, Tag(0x5200, 0x9230), perFrame);
    gdcm::DataElement pixels(Tag(0x7fe0, 0x0010));
    pixels.SetVR(VR::OW);
    pixels.SetByteValue(reinterpret_cast<const char*>(frames.data()), gdcm::VL(std::uint32_t(frames.size() * 2)));
    data.Replace(pixels);
  });
  const ImportedCt back = imported();
  EXPECT_EQ(back.ct.geometry, ct.geometry);
  ASSERT_EQ(back.ct.voxels.size(), ct.voxels.size());
  for (std::size_t v = 0; v < ct.voxels.size(); ++v)
    ASSERT_EQ(back.ct.voxels[v], std::max(-1024, ct.voxels[v] - 7)) << "voxel " << v;
}

TEST(DicomImportInput, BadInputsGetASentence) {
  test::TemporaryFolder folder;
  EXPECT_THAT(importSeries(folder / "none").error().message, HasSubstr("no file or folder"));
  EXPECT_THAT(importSeries(folder.path()).error().message, HasSubstr("holds no files"));
  test::writeText(folder / "a.dcm", "text");
  EXPECT_THAT(listSeries(folder.path()).error().message, HasSubstr("named like DICOM"));
  EXPECT_THAT(importSeries(folder / "a.dcm").error().message, HasSubstr("nothing that can be imported"));
  EXPECT_THAT(importSeries("/dev/null").error().message, HasSubstr("neither a file nor a folder"));
}

TEST_F(DicomImport, CancelsWhenAsked) {
  write(test::noiseCt(test::grid({6, 6, 3})));
  const auto cancel = [](std::string_view doing, double) { return doing != "Reading slices"; };
  EXPECT_EQ(importSeries(series, {}, cancel).error().message, kCancelled);
}

}  // namespace
}  // namespace insonate
