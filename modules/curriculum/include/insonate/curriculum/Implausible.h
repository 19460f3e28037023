#pragma once

#include <insonate/curriculum/AttemptFacts.h>

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Why an instructor should look at an attempt: hands rarely do this. It fails nothing by itself.
enum class Implausible {
  WithoutProbe,       ///< completed, and the probe neither moved, nor compressed the vein, nor showed the tip
  FastToVein,         ///< from skin to vein in less than kFastToVein_s
  WithoutNeedlePath,  ///< the needle was in the skin or the vein, and its tip moved nowhere
  Short,              ///< completed in less than kShort_s
  SameValues,         ///< all metrics of an earlier attempt, to the last digit
};

/// A vein lies about 30 mm along the needle (15 to 20 mm below the skin at 30 to 45 degrees); 10 mm/s is faster than a
/// needle is advanced under aspiration.
inline constexpr double kFastToVein_s = 3;
/// Experts need 50 s from the first puncture to access alone (Clinkard et al., Acad Emerg Med 2015, 22:212); a fifth of
/// that for the whole attempt is a choice.
inline constexpr double kShort_s = 10;

/// Name in JSON and tables: "fast_to_vein".
std::string_view idOf(Implausible flag);
/// Description for an instructor: "skin to vein in 1.5 s".
std::string wordsOf(Implausible flag, const AttemptFacts& facts);

/// Flags by an attempt's own facts, so without SameValues. None for an open attempt.
std::vector<Implausible> implausibilities(const AttemptFacts& facts);

/// Tells whether the metrics come from an attempt in which the needle reached the skin. Before that, many attempts
/// have the same values.
bool describesNeedle(const std::vector<MetricFact>& metrics);

/// Flags attempts one after the other, with SameValues among those that were added.
class PlausibilityCheck {
 public:
  std::vector<Implausible> take(const AttemptFacts& facts);

 private:
  std::set<std::vector<std::optional<double>>> values_;
};

}  // namespace insonate
