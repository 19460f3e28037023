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
  std::optional<double> value;     ///< measured value; empty if the attempt does not determine it
  std::optional<MetricNorm> norm;  ///< published values of novices and experts; empty: none are known
  /// Position of the value on a scale on which the published value of novices is 0 and that of experts is 100, clamped
  /// to 0 to 100. Empty if value or norm is missing, or if the skin was not punctured.
  std::optional<double> share;
};

/// A moment of an attempt that is worth reviewing.
struct AttemptMoment {
  std::int64_t time_us = 0;
  std::string description;           ///< description of the moment, one or more sentences
  std::optional<Severity> severity;  ///< severity, if the moment is an error; else empty
};

/// Result of an attempt.
///
/// The points are 0 if there is a critical finding. Otherwise they are the mean of the shares of all metrics
/// (MetricScore::share), minus 5 for each minor finding and 20 for each major finding, clamped to 0 to 100, and at most
/// 50 if the attempt did not succeed. Each finding of ProcedureRun counts. The numbers 5, 20 and 50 were chosen, and
/// are not the result of a study. This structure contains all terms, so that another weighting can be computed.
struct AttemptScore {
  std::optional<double> points;  ///< points, 0 to 100; empty if the skin was not punctured or no metric has a share
  bool succeeded = false;
  std::vector<MetricScore> metrics;           ///< scores of all metrics, in the order of metricTable()
  std::vector<AttemptMoment> criticalErrors;  ///< the moments with critical severity
  std::vector<AttemptMoment> moments;         ///< milestones and findings (errors), in the order of their times
  /// Advice for the next attempt, one sentence. The advice belongs to the first of the following that exists: the
  /// earliest critical finding, a major finding, the step in which the attempt ended, a minor finding, the metric with
  /// the smallest share below 90.
  std::string advice;
};

inline constexpr double kMinorDeduction = 5, kMajorDeduction = 20, kMaxPointsWithoutSuccess = 50;

/// Returns the name of the vessel whose wall an event concerns, e.g. "right internal jugular vein"; "another vein" for
/// a vein without a name. Empty if the wall is not that of a vessel, or if the vessel is unknown. `vessels`:
/// AttemptHeader::vessels.
std::string vesselName(const AttemptEvent& event, const std::vector<std::string>& vessels);

/// Returns a text that describes a finding (a broken rule) and says what to do. If the finding concerns a vessel with a
/// name, the text begins with this name.
std::string findingText(const ProcedureRule& rule, const ProcedureRun::Finding& finding);

/// Computes the score of an attempt that ended with this status, or, before its end, the score so far. Only a completed
/// attempt can succeed.
AttemptScore computeScore(const ProcedureRun& run, AttemptStatus status = AttemptStatus::Completed);

}  // namespace insonate
