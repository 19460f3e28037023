#include "CaseSamples.h"
#include "DicomFiles.h"
#include "support/TestData.h"

#include <insonate/cases/DicomWriter.h>
#include <insonate/cases/Import.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

namespace insonate {
namespace {

namespace fs = std::filesystem;
using gdcm::DataSet;
using gdcm::Tag;
using gdcm::VR;
using testing::HasSubstr;

class DicomListing : public testing::Test {
 protected:
  CtVolume write(const std::array<int, 3>& size) {
    CtVolume ct = test::noiseCt(test::grid(size, {1, 1, 2}));
    const auto written = writeDicomSeries(ct, series, {.seed = "seed"});
    EXPECT_TRUE(written) << written.error().message;
    return ct;
  }
  std::vector<fs::path> files() const {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(series)) found.push_back(entry.path());
    std::ranges::sort(found);
    return found;
  }

  test::TemporaryFolder folder;
  const fs::path series = folder / "series";
};

TEST_F(DicomListing, ADirectoryStandsForItsFolder) {
  const CtVolume ct = write({6, 6, 7});
  const fs::path directory = folder / "DICOMDIR";
  fs::copy_file(files().front(), directory);
  test::editDicom(directory,
                  [](DataSet& data) { test::setText(data, Tag(0x0008, 0x0016), VR::UI, "1.2.840.10008.1.3.10"); });
  const auto listing = listSeries(directory);
  ASSERT_TRUE(listing) << listing.error().message;
  ASSERT_EQ(listing->series.size(), 1U);
  const auto opened = importSeries(directory, listing->series[0].uid);
  ASSERT_TRUE(opened) << opened.error().message;
  EXPECT_EQ(opened->ct.voxels, ct.voxels);

  fs::create_directory(folder / "alone");
  fs::copy_file(directory, folder / "alone/DICOMDIR");
  const auto alone = listSeries(folder / "alone/DICOMDIR");
  ASSERT_FALSE(alone);
  EXPECT_THAT(alone.error().message, testing::AllOf(HasSubstr("holds no image series"), HasSubstr("an index")));
}

TEST_F(DicomListing, TheKernelTellsStacksOfOneUidApart) {
  write({6, 6, 4});
  const std::vector<fs::path> soft = files();
  fs::create_directory(series / "sharp");
  for (const fs::path& file : soft) {
    const fs::path sharp = series / "sharp" / file.filename();
    fs::copy_file(file, sharp);
    test::editDicom(file, [](DataSet& data) { test::setText(data, Tag(0x0018, 0x1210), VR::SH, "B30f"); });
    test::editDicom(sharp, [&](DataSet& data) {
      test::setText(data, Tag(0x0018, 0x1210), VR::SH, "B70f");
      test::setText(data, Tag(0x0008, 0x0018), VR::UI, "1.2.3.1" + file.stem().string().substr(5));
    });
  }
  const auto listing = listSeries(series);
  ASSERT_TRUE(listing) << listing.error().message;
  ASSERT_EQ(listing->series.size(), 2U);
  std::set<std::string> kernels;
  for (const SeriesInfo& s : listing->series) {
    kernels.insert(s.kernel);
    const auto one = importSeries(series, s.uid);
    ASSERT_TRUE(one) << one.error().message;
    EXPECT_EQ(one->series.kernel, s.kernel);
    EXPECT_THAT(one->source, testing::Not(HasSubstr(s.kernel)));
    for (const std::string& w : one->series.warnings) EXPECT_THAT(w, testing::Not(HasSubstr(s.kernel)));
  }
  EXPECT_EQ(kernels, (std::set<std::string>{"B30f", "B70f"}));
  EXPECT_THAT(seriesListText(*listing), testing::AllOf(HasSubstr("kernel B30f"), HasSubstr("kernel B70f")));
}

SeriesListing partsOfOneSeries(int count, int slices) {
  SeriesListing listing;
  for (int n = 0; n < count; ++n) {
    SeriesInfo part{
        n == 0 ? "1.2" : "1.2#" + std::to_string(n + 1), "CT", {}, {}, true, {"There is only one slice."}, {}};
    part.geometry.size = {512, 512, slices};
    listing.series.push_back(part);
  }
  return listing;
}

TEST(ListingOverview, ManySingleSlicesAreSummarized) {
  SeriesListing listing = partsOfOneSeries(273, 1);
  const auto lines = [&] {
    const std::string text = seriesListText(listing);
    return std::ranges::count(text, '\n') + 1;
  };
  EXPECT_EQ(lines(), 5) << seriesListText(listing);
  EXPECT_THAT(seriesListText(listing), HasSubstr("271 more single slices (CT) are not listed."));

  SeriesInfo stack{"1.3", "CT", {}, {}, true, {}, {}};
  stack.geometry.size = {512, 512, 120};
  listing.series.push_back(stack);
  EXPECT_EQ(overviewOf(listing).shown, (std::vector<std::size_t>{0, 1, 273}));
  for (SeriesInfo& s : listing.series) s.refusal = "No.";
  EXPECT_THAT(seriesListText(listing),
              HasSubstr("271 more single slices (CT), which cannot be imported, are not listed."));
}

TEST(ListingOverview, FewPartsAndDifferentSeriesAreListed) {
  EXPECT_EQ(overviewOf(partsOfOneSeries(12, 30)).shown.size(), 12U);
  EXPECT_EQ(overviewOf(partsOfOneSeries(13, 30)).omitted,
            std::vector<std::string>{"11 more stacks of 30 slices (CT) of the series 1.2 are not listed."});
  SeriesListing different = partsOfOneSeries(40, 30);
  for (std::size_t n = 0; n < different.series.size(); ++n) different.series[n].uid = "1." + std::to_string(n);
  EXPECT_EQ(overviewOf(different).shown.size(), 40U);
}

TEST_F(DicomListing, AnImportWithoutAChoiceNamesFewOfManyParts) {
  write({6, 6, 40});
  int n = 0;
  for (const fs::path& file : files())
    test::editDicom(file, [&](DataSet& data) {
      ++n;
      test::setText(data, Tag(0x0020, 0x0052), VR::UI, "1.2.3." + std::to_string(n));
      test::setText(data, Tag(0x0020, 0x0032), VR::DS, "0\\" + std::to_string(n % 7) + "\\" + std::to_string(n * n));
    });
  const auto imported = importSeries(series);
  ASSERT_FALSE(imported);
  EXPECT_THAT(imported.error().message, testing::AllOf(HasSubstr("holds 40 series; name the one to import"),
                                                       HasSubstr("38 more single slices (CT) are not listed.")));
  EXPECT_LT(imported.error().message.size(), 1500U);
}

}  // namespace
}  // namespace insonate
