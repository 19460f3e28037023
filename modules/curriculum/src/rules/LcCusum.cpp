#include <insonate/core/Hash.h>
#include <insonate/curriculum/LcCusum.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace insonate {
namespace {

/// The highest score of each career; fewer careers after cancellation.
std::vector<double> highestScores(const LcCusum& test, double failureRate, const CusumTrials& trials,
                                  const Progress& progress = {}) {
  constexpr std::size_t kBetweenReports = 1000;
  // Standard distributions may differ between libraries; the numbers of this engine do not.
  std::mt19937 random(trials.seed);
  const double success = test.successWeight(), failure = test.failureWeight();
  std::vector<double> highest;
  const auto careers = static_cast<std::size_t>(std::max(trials.careers, 0));
  while (highest.size() < careers) {
    if (highest.size() % kBetweenReports == 0 &&
        !report(progress, "Simulating careers", static_cast<double>(highest.size()) / static_cast<double>(careers)))
      break;
    double score = 0, most = 0;
    for (int i = 0; i < trials.trials; ++i) {
      const bool failed = unitInterval(static_cast<std::uint32_t>(random())) < failureRate;
      score = std::max(0.0, score + (failed ? failure : success));
      most = std::max(most, score);
    }
    highest.push_back(most);
  }
  return highest;
}

}  // namespace

double LcCusum::successWeight() const {
  return std::log((1 - acceptable) / (1 - unacceptable));
}

double LcCusum::failureWeight() const {
  return std::log(acceptable / unacceptable);
}

std::vector<double> LcCusum::series(const std::vector<bool>& successes) const {
  std::vector<double> scores;
  double score = 0;
  for (const bool success : successes)
    scores.push_back(score = std::max(0.0, score + (success ? successWeight() : failureWeight())));
  return scores;
}

int LcCusum::fewestToSignal(double limit) const {
  // Adds the weights as series() does, since a product may round to the other side of the limit.
  int attempts = 0;
  for (double score = 0; score < limit && attempts < kMaxToSignal; ++attempts) score += successWeight();
  return attempts;
}

double signalRate(const LcCusum& test, double limit, double failureRate, const CusumTrials& trials) {
  const std::vector<double> highest = highestScores(test, failureRate, trials);
  const auto signals = std::ranges::count_if(highest, [&](double score) { return score >= limit; });
  return highest.empty() ? 0 : static_cast<double>(signals) / static_cast<double>(highest.size());
}

Result<double> calibratedLimit(const LcCusum& test, double falseSignals, const CusumTrials& trials,
                               const Progress& progress) {
  if (!(test.acceptable > 0 && test.acceptable < test.unacceptable && test.unacceptable < 1))
    return fail("LC-CUSUM needs rates of failure between 0 and 1, the acceptable one below the unacceptable one.");
  if (!(falseSignals > 0 && falseSignals < 1))
    return fail("The share of false signals must be between 0 and 1, for example 0.1.");
  if (trials.trials < 1 || trials.careers < 1)
    return fail("Calibrating a limit needs at least one attempt of at least one simulated trainee.");
  std::vector<double> highest = highestScores(test, test.unacceptable, trials, progress);
  if (highest.size() < static_cast<std::size_t>(trials.careers)) return fail(std::string(kCancelled));
  std::ranges::sort(highest, std::greater());
  const auto allowed = static_cast<std::size_t>(falseSignals * static_cast<double>(highest.size()));
  // Scores are sums of few weights, so that many careers have equal scores except for rounding: the limit is between
  // two of them.
  constexpr double kSame = 1e-9;
  const double held = highest[allowed];
  double next = held + test.successWeight();
  for (std::size_t i = allowed; i-- > 0;)
    if (highest[i] > held + kSame) {
      next = highest[i];
      break;
    }
  return (held + next) / 2;
}

}  // namespace insonate
