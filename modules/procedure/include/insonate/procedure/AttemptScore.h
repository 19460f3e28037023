#pragma once

#include <insonate/procedure/ProcedureRun.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace insonate {

/// One metric of an attempt with the published values for comparison.
struct MetricScore {
  Metric metric = Metric::VeinPunctures;
  std::optional<double> value;     ///< empty: it does not follow from the attempt
  std::optional<MetricNorm> norm;  ///< empty: no published values are known
  /// Position of the value between the novice's (0) and the expert's value (100), clamped to 0..100. Empty if value or
  /// norm is missing.
  std::optional<double> share;
};

/// A moment of the attempt to review.
struct AttemptMoment {
  std::int64_t time_us = 0;
  std::string say;                   ///< one or more sentences
  std::optional<Severity> severity;  ///< empty: no error
};

/// Result of an attempt.
///
/// points = 0 with a critical finding; otherwise the mean of all shares, minus 5 for each minor finding and 20 for each
/// major finding, clamped to 0..100, and at most 50 if the attempt did not succeed. Findings are those of ProcedureRun,
/// each counted as often as it occurred. All metrics have equal weight in the mean. The numbers 5, 20 and 50 are a
/// choice, not the result of a study; all parts are stored here, so that another weighting can be computed.
struct AttemptScore {
  std::optional<double> points;  ///< 0..100; empty: the skin was not punctured, or no share is known
  bool succeeded = false;
  std::vector<MetricScore> metrics;           ///< all metrics, in the order of metricTable()
  std::vector<AttemptMoment> criticalErrors;  ///< the critical ones of `moments`
  std::vector<AttemptMoment> moments;         ///< milestones and findings, in the order of their times
  /// One sentence on what to do better. It is taken from the first of these that exists: the earliest critical finding,
  /// a major finding, the step in which the attempt ended, a minor finding, the metric with the smallest share below
  /// 100.
  std::string advice;
};

inline constexpr double kMinorCost = 5, kMajorCost = 20, kMostWithoutSuccess = 50;

/// Name of the vessel whose wall an event concerns: "right internal jugular vein"; "another vein" for an unnamed vein;
/// empty if the wall is not a vessel's or the vessel is unknown. `vessels` as in AttemptHeader.
std::string vesselName(const AttemptEvent& event, const std::vector<std::string>& vessels);

/// Describes a finding and says what to do; begins with the name of the punctured vessel, if any.
std::string sentenceOf(const ProcedureRule& rule, const ProcedureRun::Finding& finding);

/// Score of an attempt that ended with this status; before the end, the score so far. Only a completed attempt can
/// succeed.
AttemptScore scoreOf(const ProcedureRun& run, AttemptStatus status = AttemptStatus::Completed);

}  // namespace insonate
