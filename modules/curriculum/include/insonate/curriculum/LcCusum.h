#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <cstdint>
#include <vector>

namespace insonate {

/// Learning curve CUSUM (Biau, Williams, Schlup, Nizard, Porcher, Br J Surg 2008, 95:925): starts from "not yet able"
/// and signals once a trainee fails no more often than is acceptable.
struct LcCusum {
  double acceptable = 0.1;     ///< p0: rate of failure of who is able; above 0
  double unacceptable = 0.25;  ///< p1: of who is not; above p0, below 1

  double successWeight() const;  ///< ln((1 - p0) / (1 - p1)), positive
  double failureWeight() const;  ///< ln(p0 / p1), negative
  /// S after each attempt: max(0, S + weight), from 0.
  std::vector<double> series(const std::vector<bool>& successes) const;
  /// Number of attempts after which the score reaches a limit if all succeed; at most kMostToSignal.
  int fewestToSignal(double limit) const;
  static constexpr int kMostToSignal = 1'000'000;
};

/// Share of trainees with a known failure rate for whom the score signals within a number of trials, from simulated
/// careers.
struct CusumTrials {
  int trials = 50;
  int careers = 20'000;
  std::uint32_t seed = 1;  ///< the same seed gives the same careers
};

/// Share of careers whose score reaches `limit`: with a rate of p1 it is the rate of false signals, with p0 the power.
double signalRate(const LcCusum& test, double limit, double failureRate, const CusumTrials& trials = {});

/// The least limit by which no more than this share of the simulated trainees who fail with rate p1
/// signals. Of all such trainees it may be a little more: a share of 10 % of 20 000 careers has a standard error of
/// 0.2 %. Fails where numbers are impossible, with a sentence, or when cancelled.
Result<double> calibratedLimit(const LcCusum& test, double falseSignals, const CusumTrials& trials = {},
                               const Progress& progress = {});

}  // namespace insonate
