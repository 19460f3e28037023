#pragma once

#include <insonate/curriculum/Statistics.h>

#include <optional>
#include <string>

namespace insonate {

/// What whoever runs a curriculum knows of a metric; handed in, since metrics are defined elsewhere.
struct MetricMeaning {
  enum class Better { Lower, Higher, Neither };

  std::string id{};     ///< as in MetricFact
  int version = 1;      ///< of its definition
  std::string title{};  ///< "Punctures of the artery"
  std::string unit{};   ///< "", "s", "mm", "%"
  Better better = Better::Neither;
  std::optional<double> novice{}, expert{};  ///< what people reach, in `unit`; the expert's is the better one
  ValueKind kind = ValueKind::Any;

  /// How far a value has come from the novice's to the expert's, 0 to 100 and no further; none where a norm is missing.
  std::optional<double> share(double value) const;
  /// Whether a value is as good as the expert's: it lies in the expert band.
  bool inExpertBand(double value) const;
};

}  // namespace insonate
