#include <insonate/views/HuHistogram.h>
#include <insonate/views/TransferFunction.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace insonate::views {
namespace {

using testing::HasSubstr;

TEST(TransferFunction, IsLinearBetweenNodesAndConstantBeyond) {
  const TransferFunction function{{{0, 0.2, {0, 100, 200}}, {100, 0.6, {100, 0, 200}}}};
  EXPECT_DOUBLE_EQ(function.opacityAt(-50), 0.2);
  EXPECT_DOUBLE_EQ(function.opacityAt(25), 0.3);
  EXPECT_DOUBLE_EQ(function.opacityAt(100), 0.6);
  EXPECT_DOUBLE_EQ(function.opacityAt(3000), 0.6);
  EXPECT_EQ(function.colorAt(25), (Color{25, 75, 200}));
  EXPECT_EQ(TransferFunction{}.opacityAt(0), 0);
}

TEST(TransferFunction, IsTidied) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const TransferFunction tidy =
      sortedAndClamped({{{500, 2, {}}, {nan, 0, {}}, {500, -1, {}}, {-5000, 0.5, {}}, {9000, 0.5, {}}}});
  ASSERT_EQ(tidy.nodes.size(), 4u);
  EXPECT_EQ(tidy.nodes[0].hu, TransferFunction::kMin_HU);
  EXPECT_EQ(tidy.nodes[1].hu, 500);
  EXPECT_EQ(tidy.nodes[1].opacity, 1);
  EXPECT_EQ(tidy.nodes[2].hu, 501) << "apart by the least gap";
  EXPECT_EQ(tidy.nodes[2].opacity, 0);
  EXPECT_EQ(tidy.nodes[3].hu, TransferFunction::kMax_HU);
  TransferFunction crowd;
  for (int k = 0; k < 100; ++k) crowd.nodes.push_back({TransferFunction::kMax_HU, 0.5, {}});
  crowd = sortedAndClamped(crowd);
  EXPECT_EQ(crowd.nodes.size(), std::size_t(TransferFunction::kMaxNodes));
  EXPECT_EQ(crowd.nodes.back().hu, TransferFunction::kMax_HU);
  EXPECT_EQ(crowd.nodes.front().hu, TransferFunction::kMax_HU - TransferFunction::kMaxNodes + 1);
  EXPECT_EQ(sortedAndClamped(tidy), tidy);
}

TEST(TransferFunction, PresetsAreTidyAndComeBackFromTheirText) {
  ASSERT_EQ(transferPresets().size(), 5u);
  for (const TransferPreset& preset : transferPresets()) {
    EXPECT_EQ(sortedAndClamped(preset.function), preset.function) << preset.name;
    const auto read = readTransferFunction(writeTransferFunction(preset.function));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(*read, preset.function) << preset.name;
  }
}

TEST(TransferFunction, PresetsShowWhatTheyAreCalled) {
  const auto opacity = [](std::string_view name, double hu) {
    for (const TransferPreset& preset : transferPresets())
      if (preset.name == name) return preset.function.opacityAt(hu);
    ADD_FAILURE() << name;
    return 0.0;
  };
  EXPECT_EQ(opacity("bone", 60), 0);
  EXPECT_GT(opacity("bone", 700), 0.5);
  EXPECT_GT(opacity("soft tissue", 60), 0.1);
  EXPECT_GT(opacity("skin and bone", -350), 0.02);
  EXPECT_EQ(opacity("skin and bone", 50), 0);
  EXPECT_GT(opacity("skin and bone", 800), 0.5);
  EXPECT_GT(opacity("contrast vessels", 300), 0.4);
  EXPECT_EQ(opacity("contrast vessels", 60), 0);
  EXPECT_GT(opacity("lung", -750), 0.02);
  EXPECT_EQ(opacity("lung", 50), 0);
  for (const TransferPreset& preset : transferPresets())
    EXPECT_LT(preset.function.opacityAt(-1000), 0.01) << "air, under " << preset.name;
}

TEST(TransferFunction, SettingsOfEarlierProgramsAreRead) {
  const auto read = readTransferFunction(
      R"({"nodes":[{"hu":150.0,"opacity":0.0,"colour":"#8c523d"},{"hu":9000.0,"opacity":7.0,"colour":"#FAF5EB"}]})");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(*read, (TransferFunction{{{150, 0, {140, 82, 61}}, {TransferFunction::kMax_HU, 1, {250, 245, 235}}}}));
}

TEST(TransferFunction, WhatIsNoFunctionIsRefusedWithAReason) {
  const auto reason = [](std::string_view text) {
    const auto read = readTransferFunction(text);
    return read ? std::string() : read.error().message;
  };
  EXPECT_THAT(reason("{"), HasSubstr("not valid JSON"));
  EXPECT_THAT(reason("[]"), HasSubstr("must be an object"));
  EXPECT_EQ(reason("{}"), "The transfer function has no 'nodes'.");
  EXPECT_THAT(reason(R"({"nodes": 3})"), HasSubstr("needs a list [ ... ] as 'nodes'"));
  EXPECT_THAT(reason(R"({"nodes": [3]})"), HasSubstr("node 1"));
  EXPECT_THAT(reason(R"({"nodes": [{"hu": "x", "opacity": 1, "colour": "#000000"}]})"), HasSubstr("'hu'"));
  EXPECT_THAT(reason(R"({"nodes": [{"hu": 1, "colour": "#000000"}]})"), HasSubstr("node 1 has no 'opacity'"));
  EXPECT_THAT(reason(R"({"nodes": [{"hu": 1, "opacity": 1, "colour": "red"}]})"), HasSubstr("like \"#aa5530\""));
  EXPECT_THAT(reason(R"({"nodes": [{"hu": 1, "opacity": 1, "colour": "#00000g"}]})"), HasSubstr("'colour'"));
  EXPECT_TRUE(readTransferFunction(R"({"nodes": []})"));
}

CtVolume volumeOf(std::vector<std::int16_t> voxels) {
  CtVolume ct;
  ct.voxels = std::move(voxels);
  return ct;
}

TEST(HuHistogram, CountsEachVoxelInItsBin) {
  const HuHistogram histogram = huHistogram(volumeOf({-1000, -1000, -1000, 0, 0, 1499}), 25);
  EXPECT_EQ(histogram.min_HU, -1000);
  EXPECT_EQ(histogram.max_HU, 1500);
  ASSERT_EQ(histogram.counts.size(), 25u);
  EXPECT_EQ(histogram.binWidth_HU(), 100);
  EXPECT_EQ(histogram.counts[0], 3u);
  EXPECT_EQ(histogram.counts[10], 2u);
  EXPECT_EQ(histogram.counts[24], 1u);
  EXPECT_EQ(std::accumulate(histogram.counts.begin(), histogram.counts.end(), std::uint64_t{0}), 6u);
}

TEST(HuHistogram, SingleBrightVoxelsDoNotStretchIt) {
  std::vector<std::int16_t> voxels(300'000, 40);
  voxels[7] = 3000;
  EXPECT_EQ(huHistogram(volumeOf(voxels)).max_HU, 1500);
  std::fill_n(voxels.begin(), 300, std::int16_t{2200});
  EXPECT_EQ(huHistogram(volumeOf(voxels)).max_HU, 2201);
}

TEST(HuHistogram, NothingAndValuesBeyondTheScannersRange) {
  EXPECT_TRUE(huHistogram({}).counts.empty());
  EXPECT_EQ(huHistogram(volumeOf({-32768, 32767}), 10).counts.front(), 1u);
  const std::atomic<bool> stop = true;
  EXPECT_TRUE(huHistogram(volumeOf({1, 2}), 10, &stop).counts.empty());
}

}  // namespace
}  // namespace insonate::views
