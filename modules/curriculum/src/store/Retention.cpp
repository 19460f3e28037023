#include "store/KeptRecordings.h"
#include "store/PeopleRows.h"
#include "store/PersonErasure.h"
#include "store/RetentionRows.h"
#include "store/Session.h"

#include <insonate/curriculum/Retention.h>

#include <algorithm>

namespace insonate {
namespace {

using store::Act;
using store::Actor;
using store::Core;
using store::Row;
using store::Transaction;

constexpr int kMostMonths = 1200;
constexpr std::int64_t kRetentionPause_us = std::int64_t{24} * 3600 * 1'000'000;
/// A server that was off for longer, or whose clock jumped, waits another day, in which the clock can be corrected.
constexpr std::int64_t kLongestPause_us = 7 * kRetentionPause_us;

RetentionRule storedRule(Transaction& transaction) {
  const auto row = transaction.row("SELECT erase_months, recording_months FROM retention");
  const auto months = [&](std::size_t column) {
    return !row || row->isNull(column) ? std::nullopt : std::optional(row->count(column));
  };
  return {.erase_months = months(0), .recording_months = months(1)};
}

Result<void> checkMonths(const std::optional<int>& months) {
  if (!months || (*months >= 1 && *months <= kMostMonths)) return {};
  return fail("The rule has " + std::to_string(*months) + " months. State 1 to 1200 months, or none.");
}

/// The log has each sign-in and each other use; a person without an entry counts from the day on which the rule was
/// set.
constexpr std::string_view kLastActivity =
    "SELECT " INSONATE_PERSON_COLUMNS
    ", last_us FROM people JOIN (SELECT p.id AS person, COALESCE((SELECT MAX(last.at_us) FROM (SELECT MAX(time_us) AS "
    "at_us FROM audit WHERE actor = p.id AND allowed = 1 UNION ALL SELECT MAX(begun_us) FROM attempts WHERE person = "
    "p.id) AS last), (SELECT set_us FROM retention)) AS last_us FROM people AS p) AS activity ON activity.person = "
    "people.id WHERE role = 'trainee' AND NOT EXISTS (SELECT 1 FROM erasures WHERE erasures.person = people.id) AND "
    "last_us < ? ORDER BY last_us, people.name_key";

RetentionDue dueNow(Transaction& transaction, const Core& core, const RetentionRule& rule) {
  RetentionDue due;
  if (rule.erase_months)
    for (const Row& row : transaction.rows(kLastActivity, store::monthsBefore(core.now_us(), *rule.erase_months)))
      due.trainees.push_back({store::personOf(row), row.number(6)});
  if (rule.recording_months)
    due.attempts = store::attemptsBefore(transaction, store::monthsBefore(core.now_us(), *rule.recording_months));
  std::erase_if(due.attempts,
                [&](const std::string& attempt) { return !store::isRecordingKept(core.recordings(), attempt); });
  return due;
}

Result<void> eraseDue(Transaction& transaction, const Core& core, const RetentionDue& due, const std::string& by) {
  for (const RetentionDue::Trainee& one : due.trainees) {
    core.audit(transaction, by, "erase person", one.person.id, "retention");
    if (auto done = store::erasePerson(transaction, core, one.person.id, by); !done) return done;
  }
  store::endWorkOnRecordings(transaction, due.attempts, core.now_us());
  core.audit(transaction, by, "apply retention", "",
             std::to_string(due.trainees.size()) + " trainees, " + std::to_string(due.attempts.size()) + " recordings");
  transaction.run("UPDATE retention SET waits_us = ?, applied_us = ?", core.now_us(), core.now_us());
  return {};
}

/// Deletes the files after the transaction, also those of the people whom it has erased.
Result<void> removeDue(Core& core, const RetentionDue& due) {
  auto erased = inTransaction(core, store::Way::Read, [](Transaction& transaction) -> Result<std::vector<std::string>> {
    return store::erasedAttempts(transaction);
  });
  if (!erased) return tl::unexpected(erased.error());
  erased->insert(erased->end(), due.attempts.begin(), due.attempts.end());
  return store::removeRecordings(core.recordings(), *erased);
}

}  // namespace

Result<RetentionRule> Retention::rule() const {
  return by_.session()->read(
      {.act = Act::ManageRetention, .detail = "show"},
      [](Transaction& transaction, const Actor&) -> Result<RetentionRule> { return storedRule(transaction); });
}

Result<void> Retention::setRule(const RetentionRule& rule) const {
  for (const auto& months : {rule.erase_months, rule.recording_months})
    if (auto ok = checkMonths(months); !ok) return ok;
  const auto words = [](const std::optional<int>& months) { return months ? std::to_string(*months) : "never"; };
  const auto number = [](const std::optional<int>& months) {
    return months ? std::optional(std::int64_t{*months}) : std::nullopt;
  };
  const std::int64_t now_us = by_.session()->core().now_us();
  return by_.session()->write(
      {.act = Act::ManageRetention,
       .detail = "set erase " + words(rule.erase_months) + ", recordings " + words(rule.recording_months)},
      [&](Transaction& transaction, const Actor&) -> Result<void> {
        transaction.run(
            "UPDATE retention SET erase_months = ?, recording_months = ?, set_us = ?, waits_us = ?, applied_us = 0",
            number(rule.erase_months), number(rule.recording_months), now_us, now_us);
        return {};
      });
}

Result<RetentionDue> Retention::due(const RetentionRule& rule) const {
  for (const auto& months : {rule.erase_months, rule.recording_months})
    if (auto ok = checkMonths(months); !ok) return tl::unexpected(ok.error());
  const Core& core = by_.session()->core();
  return by_.session()->read(
      {.act = Act::ManageRetention, .detail = "preview"},
      [&](Transaction& transaction, const Actor&) -> Result<RetentionDue> { return dueNow(transaction, core, rule); });
}

Result<RetentionDue> Retention::apply() const {
  Core& core = by_.session()->core();
  auto due = by_.session()->write({.act = Act::ManageRetention, .detail = "apply"},
                                  [&](Transaction& transaction, const Actor& actor) -> Result<RetentionDue> {
                                    RetentionDue now = dueNow(transaction, core, storedRule(transaction));
                                    if (auto done = eraseDue(transaction, core, now, actor.id); !done)
                                      return tl::unexpected(done.error());
                                    return now;
                                  });
  if (!due) return due;
  if (auto removed = removeDue(core, *due); !removed) return tl::unexpected(removed.error());
  return due;
}

Result<void> RetentionSchedule::applyIfDue() {
  Core& core = *store_.core_;
  const std::int64_t now_us = core.now_us();
  const auto waited_us = [&](Transaction& transaction) -> Result<std::int64_t> {
    const auto row = transaction.row(
        "SELECT waits_us FROM retention WHERE erase_months IS NOT NULL OR recording_months IS NOT NULL");
    return row ? std::max<std::int64_t>(0, now_us - row->number(0)) : 0;
  };
  // Most of the time nothing is due, and a transaction for writing would hold up others.
  const auto waited = inTransaction(core, store::Way::Read, waited_us);
  if (!waited) return tl::unexpected(waited.error());
  if (*waited < kRetentionPause_us) return {};
  return inTransaction(core, store::Way::Write, [&](Transaction& transaction) -> Result<void> {
    const std::int64_t stillWaited_us = *waited_us(transaction);
    if (stillWaited_us < kRetentionPause_us) return {};  // another server was faster
    if (stillWaited_us > kLongestPause_us) {
      transaction.run("UPDATE retention SET waits_us = ?", now_us);
      return {};
    }
    return eraseDue(transaction, core, dueNow(transaction, core, storedRule(transaction)), "");
  });
}

Result<FilesToDelete> RetentionSchedule::applyDaily() {
  using Attempts = std::vector<std::string>;
  if (auto done = applyIfDue(); !done) return tl::unexpected(done.error());
  Core& core = *store_.core_;
  std::int64_t applied_us = 0;
  auto attempts = inTransaction(core, store::Way::Read, [&](Transaction& transaction) -> Result<Attempts> {
    applied_us = transaction.number("SELECT applied_us FROM retention");
    const auto before_us = store::recordingsDeletedBefore_us(transaction);
    return applied_us > removed_us_ && before_us ? store::attemptsBefore(transaction, *before_us) : Attempts();
  });
  if (!attempts) return tl::unexpected(attempts.error());
  FilesToDelete files{.attempts = *std::move(attempts)};
  files.recordings = store::removeRecordings(core.recordings(), files.attempts);
  if (files.recordings) removed_us_ = applied_us;
  return files;
}

}  // namespace insonate
