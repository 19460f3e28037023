#pragma once

#include <insonate/curriculum/CohortStore.h>

#include <cstdint>
#include <string>

namespace insonate {

/// State of a member of a class that may need an action of the instructor. More urgent states have higher numbers.
enum class Attention {
  None,
  Due,       ///< a mastered level lapses within kDueWithin_days unless it is practiced
  NotBegun,  ///< no attempt yet
  Idle,      ///< no attempt for kIdleAfter_days, and not all levels are mastered
  Stuck,     ///< the last attempts at an open level all failed (Concern::Stuck)
  Lapsed,    ///< a level that was mastered has lapsed (Concern::Slipped)
};
inline constexpr int kIdleAfter_days = 21, kDueWithin_days = 14;

/// Returns the most urgent state of a learner at `now_us` (since 1970, UTC). If the learner's standing is unknown or
/// outdated, states that depend on the standing are not considered. None for a learner whose account is disabled, since
/// this person has left or was erased.
Attention attentionOf(const Member& member, std::int64_t now_us);

/// Describes the state in a few words, e.g. "idle for 5 weeks"; "" for Attention::None.
std::string displayText(Attention attention, const Member& member, std::int64_t now_us);

}  // namespace insonate
