#include <insonate/curriculum/LearningCurve.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <vector>

namespace insonate {
namespace {

using Shape = LearningCurve::Shape;

using CurveValues = std::vector<std::optional<double>>;

CurveValues curve(Shape shape, double plateau, double gain, double rate, int attempts, double noise = 0,
                  std::uint32_t seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  CurveValues values;
  for (int n = 1; n <= attempts; ++n)
    values.push_back(plateau + gain * (shape == Shape::Power ? std::pow(n, -rate) : std::exp(-rate * (n - 1))) +
                     noise * normal(random));
  return values;
}

TEST(LearningCurve, FindsTheCurveThatMadeTheValues) {
  for (const Shape shape : {Shape::Power, Shape::Exponential})
    for (const double rate : {0.2, 0.5, 1.5}) {
      const auto fit = fitLearningCurve(shape, curve(shape, 50, 100, rate, 20));
      ASSERT_TRUE(fit) << rate;
      EXPECT_NEAR(fit->rate, rate, 1e-3 * rate);
      EXPECT_NEAR(fit->plateau.value, 50, 0.2);
      EXPECT_NEAR(fit->gain.value, 100, 0.2);
      EXPECT_NEAR(fit->at(1), 150, 1e-3);
      EXPECT_EQ(fit->shape, shape);
    }
}

TEST(LearningCurve, ChoosesTheShapeThatFitsBetter) {
  EXPECT_EQ(fitLearningCurve(curve(Shape::Power, 50, 100, 1, 20))->shape, Shape::Power);
  EXPECT_EQ(fitLearningCurve(curve(Shape::Exponential, 50, -30, 0.3, 20))->shape, Shape::Exponential);
}

TEST(LearningCurve, RestsAreAtRightAnglesToTheCurvesSlopes) {
  // The minimum of the squares, however it was found.
  const auto values = curve(Shape::Exponential, 50, 100, 0.3, 30, 8);
  const auto fit = fitLearningCurve(Shape::Exponential, values);
  ASSERT_TRUE(fit);
  double one = 0, byGain = 0, byRate = 0;
  for (int n = 1; n <= 30; ++n) {
    const double rest = *values[static_cast<std::size_t>(n - 1)] - fit->at(n);
    one += rest;
    byGain += rest * std::exp(-fit->rate * (n - 1));
    byRate += rest * (n - 1) * std::exp(-fit->rate * (n - 1));
  }
  EXPECT_NEAR(one, 0, 1e-6);
  EXPECT_NEAR(byGain, 0, 1e-6);
  EXPECT_NEAR(byRate, 0, 1e-2);
}

TEST(LearningCurve, IntervalsHoldTheTruthAsOftenAsTheySay) {
  int plateaus = 0, bands = 0, fits = 0;
  for (std::uint32_t seed = 1; seed <= 400; ++seed) {
    const auto fit = fitLearningCurve(Shape::Exponential, curve(Shape::Exponential, 50, 100, 0.3, 25, 10, seed));
    if (!fit) continue;
    ++fits;
    plateaus += fit->plateau.interval->low <= 50 && 50 <= fit->plateau.interval->high;
    const Interval band = fit->bandAt(5);
    const double truth = 50 + 100 * std::exp(-0.3 * 4);
    bands += band.low <= truth && truth <= band.high;
  }
  EXPECT_GT(fits, 390);
  EXPECT_NEAR(plateaus / double(fits), 0.95, 0.04);
  EXPECT_NEAR(bands / double(fits), 0.95, 0.04);
}

// Figures by Python 3.11 with mpmath 1.3 at 25 digits: least squares over the rate by golden section, spread from the
// inverse of J'J, t by bisection of mpmath.betainc().
TEST(LearningCurve, IsTheOneThatAnotherProgramFinds) {
  const CurveValues times_s{148, 121, 98, 95, 83, 72, 79, 66, 70, 64, 61, 67};
  const auto fit = fitLearningCurve(Shape::Exponential, times_s, ValueKind::NotNegative);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->plateau.value, 63.0304636, 1e-4);
  EXPECT_NEAR(fit->plateau.interval->low, 56.926408, 1e-3);
  EXPECT_NEAR(fit->plateau.interval->high, 69.134519, 1e-3);
  EXPECT_NEAR(fit->gain.value, 84.1258891, 1e-4);
  EXPECT_NEAR(fit->rate, 0.3721016718, 1e-6);
  EXPECT_NEAR(fit->residual, 4.166781767, 1e-6);
  EXPECT_NEAR(fit->at(3), 102.9997378, 1e-4);
  EXPECT_NEAR(fit->bandAt(3).high, 102.9997378 + 4.868540451, 1e-3);
}

TEST(LearningCurve, AnAttemptWithoutAValueKeepsItsNumber) {
  const CurveValues times_s{148, 121, std::nullopt, 95, 83, 72, 79, std::nullopt, 70, 64, 61, 67};
  const auto fit = fitLearningCurve(Shape::Exponential, times_s);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->attempts, 10);
  EXPECT_NEAR(fit->plateau.value, 62.35914086, 1e-4);
  EXPECT_NEAR(fit->rate, 0.3449369275, 1e-6);
  EXPECT_NEAR(fit->plateau.interval->low, 55.3641242, 1e-3);
}

TEST(LearningCurve, HasNoPlateauThatNobodyCanReach) {
  // By the same program: -1.98 s and 105.7 %.
  const CurveValues times_s{60, 46, 41, 30, 27, 19, 18, 12, 11, 8, 6},
      shares{20, 38, 50, 62, 70, 77, 82, 88, 91, 94, 96, 98};
  EXPECT_NEAR(fitLearningCurve(Shape::Exponential, times_s)->plateau.value, -1.984571, 1e-4);
  EXPECT_NEAR(fitLearningCurve(Shape::Exponential, shares)->plateau.value, 105.6907064, 1e-4);
  EXPECT_FALSE(fitLearningCurve(times_s, ValueKind::NotNegative));
  EXPECT_FALSE(fitLearningCurve(shares, ValueKind::Percent));
}

TEST(LearningCurve, PlateauAndBandStayInTheRange) {
  // A plateau of 2 that is uncertain by more than that.
  const CurveValues punctures = curve(Shape::Exponential, 2, 12, 0.35, 14, 1.6, 4);
  const auto fit = fitLearningCurve(Shape::Exponential, punctures, ValueKind::NotNegative);
  ASSERT_TRUE(fit);
  EXPECT_EQ(fit->plateau.interval->low, 0);
  const auto unbounded = fitLearningCurve(Shape::Exponential, punctures);
  EXPECT_LT(unbounded->plateau.interval->low, 0);
  EXPECT_EQ(fit->plateau.interval->high, unbounded->plateau.interval->high);
  for (int attempt = 1; attempt <= 14; ++attempt) EXPECT_GE(fit->bandAt(attempt).low, 0);
}

TEST(LearningCurve, NoiseIsSeldomTakenForLearning) {
  int power = 0, exponential = 0;
  for (std::uint32_t seed = 1; seed <= 500; ++seed) {
    const auto noise = curve(Shape::Power, 50, 0, 1, 20, 10, seed);
    power += fitLearningCurve(Shape::Power, noise).has_value();
    exponential += fitLearningCurve(Shape::Exponential, noise).has_value();
  }
  EXPECT_LT(power, 500 * 0.08);
  EXPECT_LT(exponential, 500 * 0.08);
}

TEST(LearningCurve, WhatCannotBeToldIsNotTold) {
  CurveValues line, same(20, 7.0);
  for (int n = 1; n <= 20; ++n) line.push_back(100.0 - n);
  EXPECT_FALSE(fitLearningCurve(line));  // no plateau in sight
  EXPECT_FALSE(fitLearningCurve(same));
  EXPECT_FALSE(fitLearningCurve(curve(Shape::Power, 50, 100, 1, 5)));
  EXPECT_FALSE(fitLearningCurve({}));
  auto values = curve(Shape::Power, 50, 100, 1, 20);
  values[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(fitLearningCurve(values));
  values[3] = 1e200;
  const auto fit = fitLearningCurve(values);
  EXPECT_TRUE(!fit || std::isfinite(fit->plateau.interval->high));
}

}  // namespace
}  // namespace insonate
