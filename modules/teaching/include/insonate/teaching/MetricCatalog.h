#pragma once

#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/MetricMeaning.h>
#include <insonate/teaching/MetricExplanation.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace insonate {

/// Meanings of the metrics, with the norms of novices and experts in each built-in procedure. Points are listed as
/// "points", although they are not a metric and have no norm.
class MetricCatalog {
 public:
  static const MetricCatalog& instance();

  /// Returns points first, then the metrics that have a norm in any procedure, then the other metrics.
  const std::vector<MetricMeaning>& all() const { return all_; }
  /// Returns how many entries at the beginning of all() are points or have a norm.
  std::size_t comparableCount() const { return comparableCount_; }
  /// Returns this object's copy of `meaning` that has the norms of `procedure`. Returns `meaning` itself if the
  /// procedure or the metric is unknown.
  const MetricMeaning& withNormsOf(const std::string& procedure, const MetricMeaning& meaning) const;
  /// Explains a metric, with the source of the norms of `procedure`; empty for points.
  std::vector<MetricExplanation> explanationOf(const std::string& procedure, const MetricMeaning& meaning) const;

 private:
  MetricCatalog();

  std::vector<MetricMeaning> all_;
  std::size_t comparableCount_ = 0;
  std::map<std::string, std::map<std::string, MetricMeaning>> byProcedure_;
  std::map<std::string, std::map<std::string, std::string>> sources_;  ///< MetricNorm::source by procedure and metric
};

/// Returns the attempt's value of a metric; empty if it is missing or was measured by another version of the metric.
std::optional<double> valueIn(const AttemptFacts& attempt, const MetricMeaning& meaning);
/// Returns the position of the attempt's value on the scale from novice (0) to expert (100), with the norms of the
/// attempt's procedure; for points, the points themselves. Empty if the value or the norms are missing.
std::optional<double> shareIn(const AttemptFacts& attempt, const MetricMeaning& meaning);

}  // namespace insonate
