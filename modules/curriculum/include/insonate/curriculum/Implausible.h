#pragma once

#include <insonate/curriculum/AttemptFacts.h>

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Reason why an instructor should review an attempt: hands rarely do this. A flagged attempt does not fail for that
/// reason.
enum class Implausible {
  WithoutProbe,       ///< completed, but the probe neither moved, nor compressed the vein, nor showed the tip
  FastToVein,         ///< from skin to vein in less than kFastToVein_s
  WithoutNeedlePath,  ///< the needle was in the skin or the vein, but its tip did not move
  Short,              ///< completed in less than kShort_s
  SameValues,         ///< all metrics equal those of an earlier attempt, to the last digit
};

/// Minimum plausible time from skin to vein. A vein lies about 30 mm along the needle (15 to 20 mm below the skin at 30
/// to 45 degrees); 10 mm/s is faster than a needle is advanced under aspiration.
inline constexpr double kFastToVein_s = 3;
/// Minimum plausible length of an attempt. Experts need 50 s from the first puncture to access alone (Clinkard et al.,
/// Acad Emerg Med 2015, 22:212); a fifth of that for the whole attempt was chosen here.
inline constexpr double kShort_s = 10;

/// Name of a flag in JSON and tables: "fast_to_vein".
std::string_view idOf(Implausible flag);
/// Description for an instructor: "skin to vein in 1.5 s".
std::string wordsOf(Implausible flag, const AttemptFacts& facts);

/// Returns the flags that follow from an attempt's own facts, which excludes SameValues. Empty for an open attempt.
std::vector<Implausible> implausibilities(const AttemptFacts& facts);

/// Tells whether the metrics come from an attempt in which the needle reached the skin. Before that, many attempts
/// have the same values.
bool describesNeedle(const std::vector<MetricFact>& metrics);

/// Flags attempts one after another; SameValues compares each attempt with those added before.
class PlausibilityCheck {
 public:
  std::vector<Implausible> take(const AttemptFacts& facts);

 private:
  std::set<std::vector<std::optional<double>>> values_;
};

}  // namespace insonate
