#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <cstdint>
#include <vector>

namespace insonate {

/// Learning curve CUSUM (Biau, Williams, Schlup, Nizard, Porcher, Br J Surg 2008, 95:925). The test starts from "not
/// yet able" and signals once a trainee fails no more often than is acceptable.
struct LcCusum {
  double acceptable = 0.1;     ///< p0: failure rate of a trainee who is able; above 0
  double unacceptable = 0.25;  ///< p1: failure rate of a trainee who is not able; above p0, below 1

  double successWeight() const;  ///< ln((1 - p0) / (1 - p1)), positive
  double failureWeight() const;  ///< ln(p0 / p1), negative
  /// Score S after each attempt: max(0, S + weight), starting from 0.
  std::vector<double> series(const std::vector<bool>& successes) const;
  /// Number of attempts after which the score reaches a limit if all succeed; at most kMostToSignal.
  int fewestToSignal(double limit) const;
  static constexpr int kMostToSignal = 1'000'000;
};

/// Parameters of a simulation: share of trainees with a known failure rate for whom the score signals within a number
/// of attempts.
struct CusumTrials {
  int trials = 50;
  int careers = 20'000;
  std::uint32_t seed = 1;  ///< the same seed gives the same careers
};

/// Share of simulated careers whose score reaches `limit`. With a failure rate of p1 this is the rate of false signals,
/// with p0 the power.
double signalRate(const LcCusum& test, double limit, double failureRate, const CusumTrials& trials = {});

/// Returns the minimum limit at which at most this share of simulated trainees with failure rate p1 signals. The true
/// share may be slightly larger: a share of 10 % of 20 000 careers has a standard error of 0.2 %. Fails with a sentence
/// if numbers are impossible, or if cancelled.
Result<double> calibratedLimit(const LcCusum& test, double falseSignals, const CusumTrials& trials = {},
                               const Progress& progress = {});

}  // namespace insonate
