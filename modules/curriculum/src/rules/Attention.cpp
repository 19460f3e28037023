#include <insonate/curriculum/Attention.h>

#include <algorithm>

namespace insonate {
namespace {

constexpr std::int64_t kDay_us = 86'400'000'000;

std::int64_t daysSince(std::int64_t then_us, std::int64_t now_us) {
  return std::max<std::int64_t>(now_us - then_us, 0) / kDay_us;
}

}  // namespace

Attention attentionOf(const Member& member, std::int64_t now_us) {
  // An instructor can do nothing for a person who cannot sign in.
  if (member.person.disabled) return Attention::None;
  const Standing* standing = member.standingIsCurrent && member.standing ? &*member.standing : nullptr;
  if (standing && standing->concern == Concern::Slipped) return Attention::Lapsed;
  if (standing && standing->concern == Concern::Stuck) return Attention::Stuck;
  if (!member.lastAttempt_us) return Attention::NotBegun;
  const bool isDone = standing && standing->level.empty();
  if (!isDone && daysSince(*member.lastAttempt_us, now_us) >= kIdleAfter_days) return Attention::Idle;
  if (standing && standing->mastered > 0 && standing->until_us < kForever_us &&
      standing->until_us - now_us <= kDueWithin_days * kDay_us)
    return Attention::Due;
  return Attention::None;
}

std::string displayText(Attention attention, const Member& member, std::int64_t now_us) {
  switch (attention) {
    case Attention::None:
      return "";
    case Attention::Due: {
      const std::int64_t days = daysSince(now_us, member.standing->until_us);
      return days == 0 ? "practice due today"
                       : "practice due in " + std::to_string(days) + (days == 1 ? " day" : " days");
    }
    case Attention::NotBegun:
      return "not begun";
    case Attention::Idle:
      return "idle for " + std::to_string(daysSince(*member.lastAttempt_us, now_us) / 7) + " weeks";
    case Attention::Stuck:
      return "stuck";
    case Attention::Lapsed:
      return "level lapsed";
  }
  return "";
}

}  // namespace insonate
