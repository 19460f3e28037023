#include <insonate/curriculum/MetricMeaning.h>

#include <gtest/gtest.h>

#include <limits>

namespace insonate {
namespace {

using enum MetricMeaning::Better;

TEST(MetricMeaning, ShareRunsFromNoviceToExpertEitherWay) {
  const MetricMeaning time{"time_to_access_s", 1, "Time", "s", Lower, 149, 50};
  EXPECT_EQ(time.positionBetweenNorms(149), 0);
  EXPECT_EQ(time.positionBetweenNorms(99.5), 50);  // half of the 99 s between them
  EXPECT_EQ(time.positionBetweenNorms(10), 100);
  const MetricMeaning inPicture{"tip_in_picture_percent", 1, "Tip", "%", Higher, 10, 80};
  EXPECT_EQ(inPicture.positionBetweenNorms(45), 50);
  EXPECT_EQ(inPicture.positionBetweenNorms(std::numeric_limits<double>::quiet_NaN()), std::nullopt);
}

TEST(MetricMeaning, WithoutANormThereIsNoShareAndNoBand) {
  const MetricMeaning angle{"insertion_angle_deg", 1, "Angle", "deg", Neither, {}, {}};
  EXPECT_EQ(angle.positionBetweenNorms(45), std::nullopt);
  EXPECT_FALSE(angle.inExpertBand(45));
  const MetricMeaning noSpan{"m", 1, "M", "", Lower, 3, 3};
  EXPECT_EQ(noSpan.positionBetweenNorms(3), std::nullopt);
}

TEST(MetricMeaning, TheExpertBandIsAsGoodAsTheExpert) {
  const MetricMeaning time{"t", 1, "T", "s", Lower, 149, 50};
  EXPECT_TRUE(time.inExpertBand(50));
  EXPECT_FALSE(time.inExpertBand(50.1));
  const MetricMeaning share{"s", 1, "S", "%", Higher, 10, 80};
  EXPECT_TRUE(share.inExpertBand(81));
  EXPECT_FALSE(share.inExpertBand(79));
}

}  // namespace
}  // namespace insonate
