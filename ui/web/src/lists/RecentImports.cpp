#include "lists/RecentImports.h"

#include <algorithm>

namespace insonate::web {

Response RecentImports::answer(const std::string& key, std::int64_t now_us, const std::function<Response()>& import) {
  constexpr std::size_t kMost = 50;
  const std::lock_guard one(import_);
  dropOld(now_us);
  {
    const std::lock_guard lock(mutex_);
    const auto known = std::ranges::find(kept_, key, &Kept::key);
    if (known != kept_.end()) return known->answer;
  }
  Response made = import();
  if (made.status != 200) return made;
  const std::lock_guard lock(mutex_);
  kept_.push_back({key, now_us, made});
  if (kept_.size() > kMost) kept_.pop_front();
  return made;
}

void RecentImports::dropOld(std::int64_t now_us) {
  constexpr std::int64_t kLongest_us = std::int64_t{10} * 60 * 1'000'000;
  const std::lock_guard lock(mutex_);
  // A clock that was set back ends the time, too.
  std::erase_if(kept_, [&](const Kept& one) { return now_us < one.since_us || now_us - one.since_us > kLongest_us; });
}

}  // namespace insonate::web
