#pragma once

#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/MetricMeaning.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace insonate::review {

/// Meanings of metrics, and the norms of novices and experts, in each built-in procedure. Points are listed as
/// "points", which is no metric and has no norm.
class MetricBook {
 public:
  static const MetricBook& here();

  /// Points first, then those of which any procedure has a norm, then the others.
  const std::vector<MetricMeaning>& all() const { return all_; }
  /// Number of entries of all() that are points or have a norm.
  std::size_t comparable() const { return comparable_; }
  /// Meaning with the norms of that procedure; without norms if it is unknown.
  const MetricMeaning& in(const std::string& procedure, const MetricMeaning& meaning) const;

 private:
  MetricBook();

  std::vector<MetricMeaning> all_;
  std::size_t comparable_ = 0;
  std::map<std::string, std::map<std::string, MetricMeaning>> byProcedure_;
};

/// The attempt's value; empty if it is missing or was measured by another definition.
std::optional<double> valueIn(const AttemptFacts& attempt, const MetricMeaning& meaning);
/// 0 to 100 from novice to expert in the attempt's own procedure; of points they themselves.
std::optional<double> shareIn(const AttemptFacts& attempt, const MetricMeaning& meaning);

}  // namespace insonate::review
