#include <insonate/igtlink/LinkMessage.h>

#include <SenderClock.h>
#include <gmock/gmock.h>

#include <random>

namespace insonate {
namespace {

constexpr std::int64_t kSent_ns = 1'700'000'000'000'000'000, kFrame_ns = 16'666'667;

TEST(SenderClock, RemovesTheJitterOfTheNetwork) {
  SenderClock clock;
  std::mt19937 random(5);
  std::uniform_int_distribution<std::int64_t> delay_ns(1'000'000, 12'000'000);
  std::int64_t worst_ns = 0;
  for (int i = 0; i < 2000; ++i) {
    const std::int64_t measured_ns = 1'000'000'000 + i * kFrame_ns, arrived_ns = measured_ns + delay_ns(random);
    const std::int64_t local_ns = clock.localTime_ns(kSent_ns + i * kFrame_ns, arrived_ns);
    EXPECT_LE(local_ns, arrived_ns);
    if (i > 100) worst_ns = std::max(worst_ns, std::abs(local_ns - measured_ns - 1'000'000));
  }
  EXPECT_LT(worst_ns, 1'000'000);
}

TEST(SenderClock, FollowsAClockThatIsSet) {
  SenderClock clock;
  std::int64_t arrived_ns = 1'000'000'000;
  for (int i = 0; i < 100; ++i) clock.localTime_ns(kSent_ns + i * kFrame_ns, arrived_ns += kFrame_ns);
  for (const std::int64_t step_ns : {3'600'000'000'000, -3'600'000'000'000})
    for (int i = 100; i < 200; ++i) {
      arrived_ns += kFrame_ns;
      const std::int64_t local_ns = clock.localTime_ns(kSent_ns + step_ns + i * kFrame_ns, arrived_ns);
      EXPECT_LE(local_ns, arrived_ns);
      EXPECT_GT(local_ns, arrived_ns - 1'000'000'000);
    }
}

TEST(SenderClock, TakesTheArrivalWithoutATime) {
  SenderClock clock;
  EXPECT_EQ(clock.localTime_ns(0, 42), 42);
}

}  // namespace
}  // namespace insonate
