#pragma once

#include <insonate/curriculum/Statistics.h>

#include <optional>
#include <string>

namespace insonate {

/// Properties of a metric that a curriculum needs. The caller provides them, since metrics are defined in another
/// module.
struct MetricMeaning {
  enum class Better { Lower, Higher, Neither };

  std::string id{};     ///< as in MetricFact
  int version = 1;      ///< version of the metric's definition
  std::string title{};  ///< "Punctures of the artery"
  std::string unit{};   ///< "", "s", "mm", "%"
  Better better = Better::Neither;
  std::optional<double> novice{}, expert{};  ///< typical values, in `unit`; the expert's is the better value
  ValueKind kind = ValueKind::Any;

  /// Position of a value between the novice norm (0) and the expert norm (100), clamped; empty if a norm is missing.
  std::optional<double> share(double value) const;
  /// Tells whether a value lies in the expert band.
  bool inExpertBand(double value) const;
};

}  // namespace insonate
