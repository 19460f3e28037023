#pragma once

#include <insonate/procedure/ProcedureRun.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace insonate {

/// Value of one metric of an attempt, with the published values for comparison.
struct MetricScore {
  Metric metric = Metric::VeinPunctures;
  std::optional<double> value;     ///< measured value; empty: the attempt does not determine it
  std::optional<MetricNorm> norm;  ///< published values of novices and experts; empty: none are known
  /// Position of the value on the scale from the published novice value (0) to the expert value (100), clamped to
  /// 0..100. Empty if value or norm is missing.
  std::optional<double> share;
};

/// A moment of an attempt that is worth reviewing.
struct AttemptMoment {
  std::int64_t time_us = 0;
  std::string say;                   ///< description of the moment, one or more sentences
  std::optional<Severity> severity;  ///< severity of the error; empty: the moment is no error
};

/// Result of an attempt.
///
/// points = 0 with a critical finding; otherwise the mean of all shares, minus 5 for each minor finding and 20 for each
/// major finding, clamped to 0..100, and at most 50 if the attempt did not succeed. Findings are those of ProcedureRun,
/// each counted as often as it occurred. All metrics have equal weight in the mean. The numbers 5, 20 and 50 are a
/// choice, not the result of a study; all parts are stored here, so that another weighting can be computed.
struct AttemptScore {
  std::optional<double> points;  ///< points, 0..100; empty: the skin was not punctured, or no metric has a share
  bool succeeded = false;
  std::vector<MetricScore> metrics;           ///< scores of all metrics, in the order of metricTable()
  std::vector<AttemptMoment> criticalErrors;  ///< the moments with critical severity
  std::vector<AttemptMoment> moments;         ///< milestones and findings (errors), in the order of their times
  /// Advice for the next attempt, one sentence. It is taken from the first of these that exists: the earliest critical
  /// finding, a major finding, the step in which the attempt ended, a minor finding, the metric with the smallest share
  /// below 100.
  std::string advice;
};

inline constexpr double kMinorDeduction = 5, kMajorDeduction = 20, kMaxPointsWithoutSuccess = 50;

/// Returns the name of the vessel whose wall an event concerns: "right internal jugular vein"; "another vein" for an
/// unnamed vein; empty if the wall is not a vessel's or the vessel is unknown. `vessels`: AttemptHeader::vessels.
std::string vesselName(const AttemptEvent& event, const std::vector<std::string>& vessels);

/// Returns text that describes a finding (broken rule) and says what to do; begins with the name of the punctured
/// vessel, if any.
std::string sentenceOf(const ProcedureRule& rule, const ProcedureRun::Finding& finding);

/// Computes the score of an attempt that ended with this status; before its end, the score so far. Only a completed
/// attempt can succeed.
AttemptScore scoreOf(const ProcedureRun& run, AttemptStatus status = AttemptStatus::Completed);

}  // namespace insonate
