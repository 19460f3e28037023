#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/LcCusum.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace insonate {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kThousandth = 0.001;

/// The chance of a signal by adding up all ways, not by drawing: chances of each score, trial by trial.
double exactSignalRate(const LcCusum& test, double limit, double failureRate, int trials) {
  const auto key = [](double score) { return std::llround(score * 1e9); };
  std::map<long long, std::pair<double, double>> scores{{0, {0.0, 1.0}}};
  double signalled = 0;
  for (int i = 0; i < trials; ++i) {
    std::map<long long, std::pair<double, double>> next;
    for (const auto& [at, entry] : scores)
      for (const bool success : {false, true}) {
        const double score = std::max(0.0, entry.first + (success ? test.successWeight() : test.failureWeight()));
        const double chance = entry.second * (success ? 1 - failureRate : failureRate);
        if (score >= limit)
          signalled += chance;
        else
          next.try_emplace(key(score), score, 0).first->second.second += chance;
      }
    scores = std::move(next);
  }
  return signalled;
}

TEST(LcCusum, WeightsAreThoseOfThePublishedRates) {
  const LcCusum test{0.10, 0.25};
  EXPECT_NEAR(test.successWeight(), 0.182, kThousandth);   // ln(0.90 / 0.75) = ln 1.2
  EXPECT_NEAR(test.failureWeight(), -0.916, kThousandth);  // ln(0.10 / 0.25) = ln 0.4
}

TEST(LcCusum, AGivenSeriesGivesTheSumsDoneByHand) {
  // 0.182, 0.365; a failure takes 0.916 and the score stops at 0; 0.182 to 1.094 in six; a failure leaves 0.178.
  const std::vector<double> series =
      LcCusum{0.10, 0.25}.series({true, true, false, true, true, true, true, true, true, false, true});
  EXPECT_THAT(
      series,
      ElementsAre(DoubleNear(0.182, kThousandth), DoubleNear(0.365, kThousandth), DoubleNear(0, kThousandth),
                  DoubleNear(0.182, kThousandth), DoubleNear(0.365, kThousandth), DoubleNear(0.547, kThousandth),
                  DoubleNear(0.729, kThousandth), DoubleNear(0.912, kThousandth), DoubleNear(1.094, kThousandth),
                  DoubleNear(0.178, kThousandth), DoubleNear(0.360, kThousandth)));
  EXPECT_TRUE(LcCusum{}.series({}).empty());
}

TEST(LcCusum, TellsHowManySuccessesReachALimit) {
  // ln(0.9 / 0.6) = 0.405465: ten make 4.05465, eleven 4.46012.
  const LcCusum test{0.10, 0.40};
  EXPECT_EQ(test.fewestToSignal(4.07), 11);
  EXPECT_EQ(test.fewestToSignal(4.05), 10);
  EXPECT_EQ(test.fewestToSignal(0), 0);
  const std::vector<double> scores = test.series(std::vector<bool>(11, true));
  EXPECT_LT(scores[9], 4.07);
  EXPECT_GE(scores[10], 4.07);
  EXPECT_EQ(test.fewestToSignal(scores[6]), 7) << "a limit that is a sum of weights";
  EXPECT_EQ((LcCusum{0.1, 0.1 + 1e-15}.fewestToSignal(100)), LcCusum::kMaxToSignal);
}

TEST(LcCusum, FalseSignalsAreThoseThatArePublished) {
  const LcCusum test{0.10, 0.25};
  EXPECT_NEAR(signalRate(test, 1.25, 0.25), 0.89, 0.01);
  EXPECT_NEAR(signalRate(test, 2.5, 0.25), 0.235, 0.01);
}

TEST(LcCusum, SimulationAgreesWithAddingUpAllWays) {
  const LcCusum test{0.10, 0.25};
  const CusumTrials trials{};
  for (const double limit : {0.5, 1.25, 2.0, 2.5, 3.5})
    for (const double rate : {0.05, 0.10, 0.25, 0.5}) {
      const double exact = exactSignalRate(test, limit, rate, trials.trials);
      const double deviation = std::sqrt(exact * (1 - exact) / trials.careers);
      EXPECT_NEAR(signalRate(test, limit, rate, trials), exact, 4 * deviation + 1e-9) << limit << ", " << rate;
    }
}

TEST(LcCusum, PowerFallsAsTheRateOfFailureGrows) {
  const LcCusum test{0.10, 0.25};
  double before = 1;
  for (const double rate : {0.0, 0.05, 0.10, 0.15, 0.25, 0.5, 1.0}) {
    const double power = signalRate(test, 2.5, rate);
    EXPECT_LE(power, before) << rate;
    before = power;
  }
  EXPECT_EQ(signalRate(test, 2.5, 0), 1);
  EXPECT_EQ(signalRate(test, 2.5, 1), 0);
}

TEST(LcCusum, ALimitHoldsItsRateAndIsTheLeastThatDoes) {
  const LcCusum test{0.10, 0.25};
  for (const double allowed : {0.01, 0.05, 0.1, 0.235, 0.5}) {
    const auto limit = calibratedLimit(test, allowed);
    ASSERT_TRUE(limit) << limit.error().message;
    EXPECT_LE(signalRate(test, *limit, test.unacceptable), allowed);
    // The next lower score that a career can have would let too many signal.
    double lower = *limit;
    while (signalRate(test, lower, test.unacceptable) <= allowed && lower > 0) lower -= 0.02;
    EXPECT_LT(*limit - lower, test.successWeight()) << allowed;
  }
}

TEST(LcCusum, AnySeedsLimitHoldsItsRateWithinTheErrorOfItsSimulation) {
  for (const LcCusum& test : {LcCusum{0.10, 0.25}, LcCusum{0.10, 0.40}, LcCusum{0.05, 0.20}})
    for (const double allowed : {0.05, 0.1})
      for (std::uint32_t seed = 1; seed <= 5; ++seed) {
        const CusumTrials trials{.careers = 10'000, .seed = seed};
        const double exact =
            exactSignalRate(test, *calibratedLimit(test, allowed, trials), test.unacceptable, trials.trials);
        EXPECT_LE(exact, allowed + 4 * std::sqrt(allowed * (1 - allowed) / trials.careers)) << seed;
      }
}

TEST(LcCusum, TheLimitOfTheCurriculumHoldsByAddingUpAllWays) {
  // resources/curricula/central_line.json
  EXPECT_LE(exactSignalRate({0.10, 0.40}, 4.07, 0.40, 50), 0.1);
  EXPECT_GT(exactSignalRate({0.10, 0.40}, 4.05, 0.40, 50), 0.1);
}

TEST(LcCusum, TheRuleThatANewLevelBeginsWithHoldsOneInTen) {
  const CusumRule rule;
  EXPECT_NEAR(exactSignalRate({rule.acceptable, rule.unacceptable}, rule.limit, rule.unacceptable, 50), 0.089, 0.001);
}

TEST(LcCusum, TheSameSeedGivesTheSameLimit) {
  const LcCusum test{0.05, 0.2};
  EXPECT_EQ(*calibratedLimit(test, 0.1, {50, 5000, 7}), *calibratedLimit(test, 0.1, {50, 5000, 7}));
}

TEST(LcCusum, ImpossibleNumbersAreRefused) {
  EXPECT_THAT(calibratedLimit({0.3, 0.25}, 0.1).error().message, HasSubstr("below the unacceptable"));
  EXPECT_THAT(calibratedLimit({0, 0.25}, 0.1).error().message, HasSubstr("between 0 and 1"));
  EXPECT_THAT(calibratedLimit({}, 0).error().message, HasSubstr("share of false signals"));
  EXPECT_THAT(calibratedLimit({}, std::nan("")).error().message, HasSubstr("share of false signals"));
  EXPECT_THAT(calibratedLimit({}, 0.1, {0, 100, 1}).error().message, HasSubstr("at least one attempt"));
}

TEST(LcCusum, CalibrationTellsHowFarItIsAndStops) {
  std::vector<double> told;
  const auto limit = calibratedLimit({}, 0.1, {.careers = 5000}, [&](std::string_view, double fraction) {
    told.push_back(fraction);
    return true;
  });
  EXPECT_EQ(told, (std::vector<double>{0, 0.2, 0.4, 0.6, 0.8}));
  EXPECT_EQ(*limit, *calibratedLimit({}, 0.1, {.careers = 5000}));
  const auto stopped =
      calibratedLimit({}, 0.1, {.careers = 5000}, [](auto, double fraction) { return fraction < 0.5; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().message, kCancelled);
}

}  // namespace
}  // namespace insonate
