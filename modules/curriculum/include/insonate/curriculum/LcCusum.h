#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <cstdint>
#include <vector>

namespace insonate {

/// Learning curve CUSUM (Biau, Williams, Schlup, Nizard, Porcher, Br J Surg 2008, 95:925). The test assumes that a
/// trainee is not able until it signals. It signals when the score shows that the trainee fails no more often than is
/// acceptable.
struct LcCusum {
  double acceptable = 0.1;     ///< p0: acceptable failure rate, the rate of a trainee who is able; above 0
  double unacceptable = 0.25;  ///< p1: unacceptable failure rate, the rate of a trainee who is not able; above p0,
                               ///< below 1

  double successWeight() const;  ///< change of the score by a success: ln((1 - p0) / (1 - p1)), positive
  double failureWeight() const;  ///< change of the score by a failure: ln(p0 / p1), negative
  /// Returns the score S after each attempt: S becomes max(0, S + weight), starting from 0.
  std::vector<double> series(const std::vector<bool>& successes) const;
  /// Returns the number of consecutive successes after which the score reaches `limit`; at most kMaxToSignal.
  int fewestToSignal(double limit) const;
  static constexpr int kMaxToSignal = 1'000'000;
};

/// Parameters of a simulation: `careers` simulated trainees with a known failure rate make `trials` attempts each.
struct CusumTrials {
  int trials = 50;
  int careers = 20'000;
  std::uint32_t seed = 1;  ///< seed of the random numbers
};

/// Returns the share of simulated trainees whose LC-CUSUM score reaches `limit`. For the failure rate p1 (unacceptable)
/// this is the rate of false signals, for p0 (acceptable) the power.
double signalRate(const LcCusum& test, double limit, double failureRate, const CusumTrials& trials = {});

/// Returns the smallest limit that is reached by no more than the share `falseSignals` of simulated trainees with the
/// failure rate p1 (unacceptable). The true share may be slightly larger: a share of 10 % of 20 000 trainees has a
/// standard error of 0.2 %. Fails with a sentence on impossible numbers, or if cancelled.
Result<double> calibratedLimit(const LcCusum& test, double falseSignals, const CusumTrials& trials = {},
                               const Progress& progress = {});

}  // namespace insonate
