#pragma once

#include <insonate/curriculum/Statistics.h>

#include <optional>
#include <string>

namespace insonate {

/// Properties of a metric that this module needs. The caller provides them, since the module `procedure` defines the
/// metrics.
struct MetricMeaning {
  enum class Better { Lower, Higher, Neither };

  std::string id{};     ///< id of the metric: MetricFact::id
  int version = 1;      ///< version of the metric's definition
  std::string title{};  ///< name shown to users: "Punctures of the artery"
  std::string unit{};   ///< unit of the values: "", "s", "mm", "%"
  Better better = Better::Neither;
  /// published typical values of novices and of experts, in `unit`; the value of experts is the better one
  std::optional<double> novice{}, expert{};
  ValueKind kind = ValueKind::Any;

  /// Returns the position of a value on the scale from the value of novices (0) to the value of experts (100), clamped
  /// to 0 to 100; empty if `novice` or `expert` is missing.
  std::optional<double> positionBetweenNorms(double value) const;
  /// Returns the same position without clamping, for means: the mean of the positions of values is the position of the
  /// mean of the values.
  std::optional<double> unclampedPosition(double value) const;
  /// Tells whether a value is at least as good as the expert value.
  bool inExpertBand(double value) const;
};

}  // namespace insonate
