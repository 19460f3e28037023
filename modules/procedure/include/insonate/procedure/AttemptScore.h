#pragma once

#include <insonate/procedure/ProcedureRun.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace insonate {

/// One metric of an attempt beside published values.
struct MetricScore {
  Metric metric = Metric::VeinPunctures;
  std::optional<double> value;     ///< none: the attempt does not tell
  std::optional<MetricNorm> norm;  ///< none: none is known
  /// 0..100: how far the value has come from the novice's to the expert's, and no further. None where one of the two
  /// is missing.
  std::optional<double> share;
};

/// Something to look at again.
struct AttemptMoment {
  std::int64_t time_us = 0;
  std::string say;                   ///< one or more sentences
  std::optional<Severity> severity;  ///< none: nothing went wrong
};

/// Result of an attempt.
///
/// points = 0 with a critical finding; otherwise the mean of all shares, minus 5 for each minor finding and 20 for
/// each major one, clamped to 0..100, and at most 50 if the attempt did not succeed. Findings are those of
/// ProcedureRun, each counted as often as it occurred. The mean weighs all metrics alike, and 5, 20 and 50 are a
/// choice, not the result of a study: all parts are stored here, so that another weighting can be computed.
struct AttemptScore {
  std::optional<double> points;  ///< 0..100; none: the skin was not punctured, or no share is known
  bool succeeded = false;
  std::vector<MetricScore> metrics;           ///< all, in the order of metricTable()
  std::vector<AttemptMoment> criticalErrors;  ///< those of `moments` that are critical
  std::vector<AttemptMoment> moments;         ///< in the order of their times: milestones and findings
  /// One sentence on what to do better: the first of these that there is, of a critical finding (the earliest), a major
  /// one, the step in which the attempt ended, a minor finding, the metric with the least share below 100.
  std::string advice;
};

inline constexpr double kMinorCost = 5, kMajorCost = 20, kMostWithoutSuccess = 50;

/// Name of the vessel whose wall an event is at: "right internal jugular vein"; "another vein" for an unnamed vein;
/// empty if it is no vessel's wall or unknown. `vessels` as in AttemptHeader.
std::string vesselName(const AttemptEvent& event, const std::vector<std::string>& vessels);

/// Describes a finding and what to do, after the name of the punctured vessel, if any.
std::string sentenceOf(const ProcedureRule& rule, const ProcedureRun::Finding& finding);

/// Score of an attempt that ended with this status, or as things stand. Only a completed attempt can succeed.
AttemptScore scoreOf(const ProcedureRun& run, AttemptStatus status = AttemptStatus::Completed);

}  // namespace insonate
