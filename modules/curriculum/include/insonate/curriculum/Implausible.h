#pragma once

#include <insonate/curriculum/AttemptFacts.h>

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Flag of an attempt with implausible values, which an instructor should review. The flag alone does not make the
/// attempt fail.
enum class Implausible {
  WithoutProbe,  ///< completed, but the probe was not moved, did not compress the vein and did not show the needle's
                 ///< tip
  FastToVein,    ///< the needle went from skin to vein in less than kFastToVein_s
  WithoutNeedlePath,  ///< the needle punctured skin or vein, but its recorded tip did not move
  Short,              ///< completed in less than kShort_s
  SameValues,         ///< all metrics are exactly equal to those of an earlier attempt
};

/// Minimum plausible time from skin to vein. A vein lies about 30 mm along the needle (15 to 20 mm below the skin at 30
/// to 45 degrees); 10 mm/s is faster than a needle is advanced under aspiration.
inline constexpr double kFastToVein_s = 3;
/// Minimum plausible duration of an attempt. Experts need 50 s for the part from the first puncture to access (Clinkard
/// et al., Acad Emerg Med 2015, 22:212); a fifth of this time was chosen as the limit for the whole attempt.
inline constexpr double kShort_s = 10;

/// Returns the name of a flag in JSON and tables: "fast_to_vein".
std::string_view idOf(Implausible flag);
/// Returns the description of a flag for an instructor: "implausibly fast: time to vein 1.5 s".
std::string displayText(Implausible flag, const AttemptFacts& facts);

/// Returns the flags that follow from one attempt alone, all except SameValues. Empty for an attempt that has not
/// ended.
std::vector<Implausible> implausibilities(const AttemptFacts& facts);

/// Tells whether the needle reached the skin in the attempt with these metrics. Attempts in which it did not reach the
/// skin all have the same values; Implausible::SameValues is therefore not applied to them.
bool describesNeedle(const std::vector<MetricFact>& metrics);

/// Finds implausible attempts in a sequence of attempts. Call check() for each attempt in turn; it returns the flags of
/// this attempt. For SameValues, the attempt is compared with all attempts of earlier calls.
class PlausibilityCheck {
 public:
  std::vector<Implausible> check(const AttemptFacts& facts);

 private:
  std::set<std::vector<std::optional<double>>> values_;
};

}  // namespace insonate
