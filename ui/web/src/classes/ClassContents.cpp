#include "classes/ClassContents.h"

#include <insonate/curriculum/ClassAccess.h>
#include <insonate/curriculum/StoreChanges.h>

#include <algorithm>
#include <utility>

namespace insonate::web {
namespace {

/// A content has 0.1 to 1 MB.
constexpr std::size_t kMostContents = 50;
constexpr std::int64_t kLongestUse_us = 60'000'000;

bool isRecent(std::int64_t time_us, std::int64_t now_us) {
  return time_us <= now_us && now_us - time_us < kLongestUse_us;
}

}  // namespace

/// Contents that were not used for a minute are dropped, so that names of people do not stay in memory.
std::shared_ptr<ClassContents::Entry> ClassContents::entryOf(const std::string& cohort, std::int64_t now_us) {
  const std::lock_guard lock(mutex_);
  std::erase_if(entries_, [&](const auto& one) { return !isRecent(one.second->used_us, now_us); });
  if (entries_.size() >= kMostContents && !entries_.contains(cohort))
    entries_.erase(std::ranges::min_element(entries_, {}, [](const auto& one) { return one.second->used_us; }));
  std::shared_ptr<Entry>& entry = entries_[cohort];
  if (!entry) entry = std::make_shared<Entry>();
  entry->used_us = now_us;
  return entry;
}

/// The people are compared as well: the log names new members only by ids that the content does not have, and does not
/// name users who change their own details.
Result<bool> ClassContents::isCurrent(const Entry& entry, const Visit& visit, const Cohort& cohort,
                                      const std::set<std::string>& changed) {
  if (entry.number < 0 || entry.cohort != cohort || !isRecent(entry.read_us, visit.by->now_us())) return false;
  const std::vector<Person>& people = entry.content.people;
  if (changed.contains("") || std::ranges::any_of(people, [&](const Person& one) { return changed.contains(one.id); }))
    return false;
  const auto present = seeClass(*visit.by, cohort.id, isByItself(visit.request));
  if (!present) return tl::unexpected(present.error());
  return *present == people;
}

Result<ClassContents::Shown> ClassContents::show(const Visit& visit, const Cohort& cohort, const Read& read) {
  const auto entry = entryOf(cohort.id, visit.by->now_us());
  const std::lock_guard lock(entry->mutex);
  // Before the people and the content: what changes meanwhile is found by the next request.
  StoreChanges changes(visit.store.guest(), entry->number);
  const auto changed = changes.readChanges();
  if (!changed) return tl::unexpected(changed.error());
  const auto current = isCurrent(*entry, visit, cohort, *changed);
  if (!current) return tl::unexpected(current.error());
  if (!*current) {
    entry->number = -1;
    entry->read_us = visit.by->now_us();
    auto content = read();
    if (!content) return tl::unexpected(content.error());
    entry->content = std::move(*content);
    entry->cohort = cohort;
  }
  entry->number = changes.number();
  return Shown{.sections = entry->content.sections, .number = entry->number};
}

}  // namespace insonate::web
