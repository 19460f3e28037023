#include "realism/SourceClassifier.h"
#include "support/TestData.h"

#include <insonate/bench/AppearanceFeatures.h>
#include <insonate/bench/RealismBench.h>
#include <insonate/simulator/ImageFiles.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>
#include <random>
#include <set>

namespace insonate {
namespace {

using testing::HasSubstr;

// Known answers of the ROC area: computed by a few lines of Python that count pairs and take the variances of DeLong's
// structural components.

TEST(RocArea, IsTheShareOfPairsWithDeLongsInterval) {
  const std::vector<double> positive{0.8, 0.6, 0.9, 0.4}, negative{0.1, 0.5, 0.7, 0.3};
  const RocArea told = rocArea(positive, negative);
  EXPECT_DOUBLE_EQ(told.area, 0.8125);
  EXPECT_NEAR(told.low, 0.32935, 1e-5);
  EXPECT_NEAR(told.high, 0.97451, 1e-5);
  EXPECT_NEAR(rocP(positive, negative), 0.14891, 5e-5);
}

TEST(RocArea, TiesCountByHalfAndFewValuesHaveNoInterval) {
  EXPECT_DOUBLE_EQ(rocArea(std::vector{1.0, 1.0}, std::vector{1.0, 1.0}).area, 0.5);
  const RocArea single = rocArea(std::vector{2.0}, std::vector{1.0, 0.0});
  EXPECT_DOUBLE_EQ(single.area, 1);
  EXPECT_DOUBLE_EQ(single.low, 0);
}

TEST(RocArea, AlwaysToldStaysWithinItsRange) {
  const std::vector<double> high{5, 6, 7, 8, 9, 10, 11, 12, 13, 14}, low{1, 2, 3, 4, 4, 3, 2, 1, 0, 0};
  const RocArea told = rocArea(high, low);
  EXPECT_DOUBLE_EQ(told.area, 1);
  EXPECT_DOUBLE_EQ(told.high, 1);
  EXPECT_NEAR(told.low, std::pow(0.025, 1.0 / 10), 1e-12) << "Clopper and Pearson, 10 of 10";
  EXPECT_NEAR(rocArea(low, high).high, 1 - told.low, 1e-12);
}

TEST(RocArea, ReadersThatGuessAreNotBelieved) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> rating(1, 6);
  std::vector<ReaderRatings> readers(3);
  for (ReaderRatings& reader : readers)
    for (int n = 0; n < 40; ++n) reader.positive.push_back(rating(random)), reader.negative.push_back(rating(random));
  const RocArea told = readersRocArea(readers);
  EXPECT_LT(told.low, 0.5);
  EXPECT_GT(told.high, 0.5);
  EXPECT_NEAR(told.high - told.low, 0.18, 0.1);
  EXPECT_EQ(readersRocArea(readers).low, told.low) << "the same seed";
}

GrayImage painted(const std::function<double(double x_mm, double z_mm)>& gray, double width_mm = 30,
                  double depth_mm = 30) {
  GrayImage picture{int(width_mm * kFeaturePixelsPer_mm), int(depth_mm * kFeaturePixelsPer_mm), {}};
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      picture.gray.push_back(
          std::uint8_t(std::clamp(std::lround(gray(x / kFeaturePixelsPer_mm, y / kFeaturePixelsPer_mm)), 0L, 255L)));
  return picture;
}

double valueOf(const GrayImage& picture, const std::string& name) {
  const auto features = appearanceFeatures(picture);
  const auto found = std::ranges::find(features, name, &AppearanceFeature::name);
  if (found == features.end()) throw std::runtime_error("no feature " + name);
  return found->value;
}

TEST(AppearanceFeatures, PowerLiesAtTheFrequencyOfThePattern) {
  const auto wave = [](double perMm, bool lateral) {
    return painted(
        [=](double x, double z) { return 100 + 50 * std::sin(2 * std::numbers::pi * perMm * (lateral ? x : z)); });
  };
  EXPECT_GT(valueOf(wave(1.5, true), "lateral power above 1/mm"), 0.98);
  EXPECT_LT(valueOf(wave(1.5, true), "lateral power above 2/mm"), 0.02);
  EXPECT_GT(valueOf(wave(2.5, false), "axial power above 2/mm"), 0.98);
  EXPECT_LT(valueOf(wave(0.5, false), "axial power above 1/mm"), 0.02);
}

TEST(AppearanceFeatures, RailsCorrelateAlongTheFaceAndGrainsDoNot) {
  const auto rails = painted([](double, double z) { return std::fmod(z, 5) < 0.4 ? 200 : 30; });
  EXPECT_GT(valueOf(rails, "ridge correlation at 4 mm"), 0.99);
  EXPECT_NEAR(valueOf(rails, "ridge length, mm"), 30, 0.1);
  std::mt19937 random(1);
  std::normal_distribution<double> normal(100, 20);
  const auto grains = painted([&](double, double) { return normal(random); });
  EXPECT_LT(valueOf(grains, "ridge correlation at 0.5 mm"), 0.65);
  EXPECT_LT(valueOf(grains, "ridge length, mm"), 3);
  EXPECT_NEAR(valueOf(grains, "pixel noise / mean at 0 to 10 mm"), 0.2, 0.01) << "its standard deviation over its mean";
  EXPECT_NEAR(valueOf(grains, "gray p50"), 100, 0.6);
  EXPECT_NEAR(valueOf(grains, "gray p95"), 100 + 1.645 * 20, 1);
}

/// White noise blurred by a Gaussian has a Gaussian autocorrelation, wider by the root of two: a full width at half
/// height of 2.355 sqrt(2) sigma.
TEST(AppearanceFeatures, GrainHasTheWidthOfItsBlur) {
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  constexpr int kSide = 300, kReach = 12;
  constexpr double kLateral_px = 2, kAxial_px = 1;
  std::vector<double> noise(kSide * kSide), across(kSide * kSide), both(kSide * kSide);
  for (double& value : noise) value = normal(random);
  const auto blur = [&](const std::vector<double>& from, std::vector<double>& to, double sigma_px, int step) {
    for (int n = 0; n < kSide * kSide; ++n) {
      double sum = 0;
      for (int k = -kReach; k <= kReach; ++k)
        sum += std::exp(-k * k / (2 * sigma_px * sigma_px)) * from[(n + k * step + kSide * kSide) % (kSide * kSide)];
      to[n] = sum;
    }
  };
  blur(noise, across, kLateral_px, 1), blur(across, both, kAxial_px, kSide);
  int at = 0;
  const auto image = painted([&](double, double) { return 120 + 4 * both[at++]; });
  EXPECT_NEAR(valueOf(image, "grain lateral, mm at 10 to 20 mm"), 2.355 * std::sqrt(2) * kLateral_px / 10, 0.06);
  EXPECT_NEAR(valueOf(image, "grain axial, mm at 10 to 20 mm"), 2.355 * std::sqrt(2) * kAxial_px / 10, 0.05);
}

TEST(AppearanceFeatures, ImagesAreBroughtToOneScaleAndCut) {
  GrayImage picture{400, 1000, std::vector<std::uint8_t>(400 * 1000, 80)};
  const auto scaled = atFeatureScale(picture, 20);
  ASSERT_TRUE(scaled) << scaled.error().message;
  EXPECT_EQ(scaled->width, 200);
  EXPECT_EQ(scaled->height, 300) << "30 mm of 50";
  EXPECT_EQ(scaled->gray[777], 80);
  EXPECT_THAT(atFeatureScale(picture, 0).error().message, HasSubstr("1 to 100 pixels per mm"));
  EXPECT_THAT(atFeatureScale(picture, 80).error().message, HasSubstr("smaller than 10 x 10 mm"));
}

/// Real and simulated rows of several sources; each source has an offset of its own, a third feature tells.
std::vector<bench::FeatureRow> rowsWith(double difference) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::vector<bench::FeatureRow> rows;
  for (int source = 0; source < 12; ++source) {
    const double offset = 3 * normal(random);
    for (int n = 0; n < 10; ++n)
      rows.push_back({"source " + std::to_string(source),
                      source % 2 == 1,
                      {offset + normal(random), normal(random), normal(random) + difference * (source % 2)}});
  }
  return rows;
}

double classified(const std::vector<bench::FeatureRow>& rows) {
  const std::vector<double> scores = bench::leaveOneSourceOut(rows);
  std::vector<double> real, made;
  for (std::size_t n = 0; n < rows.size(); ++n) (rows[n].simulated ? made : real).push_back(scores[n]);
  return rocArea(made, real).area;
}

TEST(SourceClassifier, LearnsWhatTellsAndNotTheSources) {
  EXPECT_GT(classified(rowsWith(4)), 0.95);
  EXPECT_LT(classified(rowsWith(0)), 0.7) << "offsets of sources that it never saw do not help";
}

SourceImage sourceImage(const std::string& source, unsigned seed, double level) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(level, 25);
  return {source, source + " " + std::to_string(seed), painted([&](double, double) { return normal(random); }, 20, 15)};
}

RealismBench smallBench() {
  RealismBench bench;
  for (unsigned n = 0; n < 5; ++n) {
    bench.real.push_back(sourceImage("machine", n, 90));
    bench.simulated.push_back(sourceImage("textbook", n, 120));
  }
  return bench;
}

std::string textOf(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(BlindTest, NothingThatReadersGetTellsWhichIsWhich) {
  const test::TemporaryFolder folder;
  const auto written = writeRealismBench(smallBench(), folder / "new");
  ASSERT_TRUE(written) << written.error().message;
  std::set<std::pair<int, int>> sizes;
  int images = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "new/blind")) {
    const std::string name = entry.path().filename().string();
    EXPECT_THAT(textOf(entry.path()), testing::Not(HasSubstr("textbook"))) << name;
    EXPECT_THAT(textOf(entry.path()), testing::Not(HasSubstr("machine 1"))) << name;
    if (entry.path().extension() != ".jpg") continue;
    const auto picture = readGrayImage(entry.path());
    ASSERT_TRUE(picture) << picture.error().message;
    sizes.emplace(picture->width, picture->height), ++images;
  }
  EXPECT_EQ(images, 10);
  EXPECT_EQ(sizes.size(), 1u);
  EXPECT_THAT(textOf(folder / "new/key.csv"), HasSubstr("textbook"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "new/blind/sheet-1.png"));
}

class Ratings : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder_ / "key.csv") << "number,simulated,source,about\n1,1,a,b\n2,0,a,b\n3,1,a,b\n4,0,a,b\n";
  }
  Result<BlindResult> score(const std::vector<std::string>& readers) {
    std::vector<std::filesystem::path> files;
    for (const std::string& ratings : readers) {
      files.emplace_back(folder_ / ("reader" + std::to_string(files.size())));
      std::ofstream(files.back()) << ratings;
    }
    return scoreBlindTest(folder_ / "key.csv", files);
  }
  const test::TemporaryFolder folder_;
};

TEST_F(Ratings, AreScoredOverReaders) {
  const auto result = score({"number,rating\n1,6\n2,1\n3,5\n4,3\n# sharp edges\n", "1,4\n2,4\n3,2\n4,2\n"});
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->readers, 2);
  EXPECT_EQ(result->images, 4);
  EXPECT_DOUBLE_EQ(result->sensitivity, (1 + 0.5) / 2);
  EXPECT_DOUBLE_EQ(result->specificity, (1 + 0.5) / 2);
  EXPECT_DOUBLE_EQ(result->separation.area, (1 + 0.5) / 2);
}

TEST_F(Ratings, ThatAreMissingDoubledOrWrongAreNamed) {
  EXPECT_THAT(score({"1,6\n2,1\n3,5\n"}).error().message, HasSubstr("no rating of image 4"));
  EXPECT_THAT(score({"1,6\n1,1\n"}).error().message, HasSubstr("Line 2"));
  EXPECT_THAT(score({"1,7\n"}).error().message, HasSubstr("a rating from 1 to 6"));
  EXPECT_THAT(score({"1,\n"}).error().message, HasSubstr("a rating from 1 to 6"));
  EXPECT_THAT(score({"1,6\n2,1\n3,5\n4,1\n9,1\n"}).error().message, HasSubstr("image 9"));
}

TEST(RealImages, ListsAreReadAndTheirFaultsNamed) {
  const test::TemporaryFolder folder;
  const auto write = [&](const std::string& text) { std::ofstream(folder / "list.csv") << text; };
  BModeImage image;
  image.width = 600, image.height = 500, image.pixel_mm = 0.05, image.gray.assign(600 * 500, 77);
  ASSERT_TRUE(writePng(image, folder / "a.png"));
  write("# mine\na.png, 20, machine A\n");
  const auto images = readRealImages(folder / "list.csv");
  ASSERT_TRUE(images) << images.error().message;
  ASSERT_EQ(images->size(), 1u);
  EXPECT_EQ(images->front().source, "machine A");
  EXPECT_EQ(images->front().image.width, 300);
  write("a.png,20,A,100,50,400,300\n");
  EXPECT_EQ(readRealImages(folder / "list.csv")->front().image.height, 150);
  write("a.png,20,A,300,50,400,300\n");
  EXPECT_THAT(readRealImages(folder / "list.csv").error().message, HasSubstr("600 x 500 pixels"));
  write("a.png,20,A\nb.png,20,A\n");
  EXPECT_THAT(readRealImages(folder / "list.csv").error().message, HasSubstr("Line 2"));
  write("a.png,twenty,A\n");
  EXPECT_THAT(readRealImages(folder / "list.csv").error().message, HasSubstr("its pixels per mm and its source"));
  write("# nothing\n");
  EXPECT_THAT(readRealImages(folder / "list.csv").error().message, HasSubstr("lists no images"));
}

/// A person turns the gain until an image is neither black nor milky, whatever machine and gray map it has.
TEST(SimulatedImages, AreExposedAsPeopleDo) {
  const auto images = simulatedImages({.count = 2, .seed = 4}, {});
  ASSERT_TRUE(images) << images.error().message;
  for (const SourceImage& image : *images) {
    std::vector<std::uint8_t> gray = image.image.gray;
    std::ranges::nth_element(gray, gray.begin() + std::ptrdiff_t(gray.size() / 2));
    EXPECT_GT(gray[gray.size() / 2], 18) << image.about;
    EXPECT_LT(gray[gray.size() / 2], 130) << image.about;
  }
}

}  // namespace
}  // namespace insonate
