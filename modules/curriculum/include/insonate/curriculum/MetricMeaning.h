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
  /// published typical values of novices and experts, in `unit`; the expert's is the better one
  std::optional<double> novice{}, expert{};
  ValueKind kind = ValueKind::Any;

  /// Returns the position of a value on the scale from the novice value (0) to the expert value (100), clamped; empty
  /// if one of these is missing.
  std::optional<double> share(double value) const;
  /// Tells whether a value is at least as good as the expert value.
  bool inExpertBand(double value) const;
};

}  // namespace insonate
