#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <gtest/gtest.h>

namespace insonate {
namespace {

Result<int> half(int value) {
  if (value % 2) return fail(std::to_string(value) + " is odd.");
  return value / 2;
}

TEST(Result, CarriesAValueOrASentence) {
  ASSERT_TRUE(half(8));
  EXPECT_EQ(*half(8), 4);
  ASSERT_FALSE(half(7));
  EXPECT_EQ(half(7).error().message, "7 is odd.");
}

TEST(Progress, AnEmptyListenerNeverCancels) {
  EXPECT_TRUE(report({}, "reading", 0.5));
}

TEST(Progress, TheListenerHearsAndDecides) {
  std::string heard;
  double fraction = 0;
  const Progress listener = [&](std::string_view doing, double f) {
    heard = doing;
    fraction = f;
    return f < 0.5;
  };
  EXPECT_TRUE(report(listener, "reading", 0.25));
  EXPECT_FALSE(report(listener, "labeling", 0.75));
  EXPECT_EQ(heard, "labeling");
  EXPECT_EQ(fraction, 0.75);
}

}  // namespace
}  // namespace insonate
