#include "store/PeopleRows.h"
#include "store/PersonErasure.h"
#include "store/RetentionRows.h"
#include "store/Session.h"
#include "store/StoredRecordings.h"

#include <insonate/curriculum/Retention.h>

#include <algorithm>
#include <map>
#include <optional>

namespace insonate {
namespace {

using store::Act;
using store::Actor;
using store::Core;
using store::Row;
using store::Transaction;

constexpr int kMaxMonths = 1200;
constexpr std::int64_t kRetentionPause_us = std::int64_t{24} * 3600 * 1'000'000;
/// A server that was off for longer, or whose clock jumped, waits another day, in which the clock can be corrected.
constexpr std::int64_t kLongestPause_us = 7 * kRetentionPause_us;
/// A rule that waits since a later time was written while a clock was wrong, and waits from now on.
constexpr std::int64_t kClockDifference_us = std::int64_t{60} * 1'000'000;

RetentionRule storedRule(Transaction& transaction) {
  const auto row = transaction.row("SELECT erase_months, recording_months FROM retention");
  const auto months = [&](std::size_t column) {
    return !row || row->isNull(column) ? std::nullopt : std::optional(row->count(column));
  };
  return {.erase_months = months(0), .recording_months = months(1)};
}

Result<void> checkMonths(const std::optional<int>& months) {
  if (!months || (*months >= 1 && *months <= kMaxMonths)) return {};
  return fail("The rule has " + std::to_string(*months) + " months. State 1 to 1200 months, or none.");
}

/// Last activity of trainees: use of the account, an attempt, a new password, enabling, or joining a class. The first
/// parameter is the time from which a person without any counts; the second and third one restrict the query to a
/// person, or are "".
constexpr std::string_view kLastActivity =
    "SELECT " INSONATE_PERSON_COLUMNS
    ", last_us FROM people JOIN (SELECT p.id AS person, COALESCE((SELECT MAX(last.at_us) FROM (SELECT MAX(time_us) AS "
    "at_us FROM audit WHERE actor = p.id AND allowed = 1 UNION ALL SELECT MAX(begun_us) FROM attempts WHERE person = "
    "p.id UNION ALL SELECT MAX(time_us) FROM audit WHERE person = p.id AND allowed = 1 AND (act = 'reset password' OR "
    "(act = 'change cohorts' AND detail LIKE 'learns%') OR (act = 'change person' AND detail NOT LIKE '%disabled%'))) "
    "AS "
    "last), ?) AS last_us FROM people AS p WHERE ? = '' OR p.id = ?) AS activity ON activity.person = "
    "people.id WHERE role = 'trainee' AND NOT EXISTS (SELECT 1 FROM erasures WHERE erasures.person = people.id) AND "
    "last_us < ? ORDER BY last_us, people.name_key";

std::vector<RetentionDue::Trainee> inactiveBefore(Transaction& transaction, std::int64_t before_us,
                                                  const std::string& person = {}) {
  const std::int64_t set_us = transaction.number("SELECT set_us FROM retention");
  std::vector<RetentionDue::Trainee> trainees;
  for (const Row& row : transaction.rows(kLastActivity, set_us, person, person, before_us))
    trainees.push_back({store::personOf(row), row.number(6)});
  return trainees;
}

/// Times at which accounts were added, by Person::id. Reads the whole log, since these entries name no person.
std::map<std::string, std::int64_t> timesOfAdding(Transaction& transaction) {
  constexpr std::size_t kIdLetters = 36;
  std::map<std::string, std::int64_t> times;
  for (const Row& row :
       transaction.rows("SELECT detail, time_us FROM audit WHERE act IN ('add person', 'add trainee') AND allowed = 1"))
    times[row.text(0).substr(0, kIdLetters)] = row.number(1);
  return times;
}

RetentionDue dueNow(Transaction& transaction, const Core& core, const RetentionRule& rule) {
  RetentionDue due;
  if (rule.erase_months) {
    const std::int64_t before_us = store::monthsBefore(core.now_us(), *rule.erase_months);
    due.trainees = inactiveBefore(transaction, before_us);
    const auto added = due.trainees.empty() ? std::map<std::string, std::int64_t>() : timesOfAdding(transaction);
    std::erase_if(due.trainees, [&](const RetentionDue::Trainee& one) {
      const auto found = added.find(one.person.id);
      return found != added.end() && found->second >= before_us;
    });
  }
  if (rule.recording_months)
    due.attempts = store::attemptsBefore(transaction, store::monthsBefore(core.now_us(), *rule.recording_months));
  return due;
}

/// Leaves the attempts of which this database's folder has recordings. Not within a transaction, since a network folder
/// can be slow.
void leaveKept(const Core& core, RetentionDue& due) {
  std::erase_if(due.attempts,
                [&](const std::string& attempt) { return !store::isRecordingKept(core.recordings(), attempt); });
}

/// Erases a person, unless the person has become active meanwhile.
Result<void> eraseInactive(Core& core, const std::string& person, std::int64_t before_us, const std::string& by) {
  return inTransaction(core, store::Way::Write, [&](Transaction& transaction) -> Result<void> {
    if (inactiveBefore(transaction, before_us, person).empty()) return {};
    core.audit(transaction, by, "erase person", person, "retention");
    return store::erasePerson(transaction, core, person, by);
  });
}

/// Applies the rule, each person in a transaction of its own: others can work meanwhile, and a person who cannot be
/// erased keeps no other one. Returns the first failure.
Result<void> applyRule(Core& core, const RetentionRule& rule, RetentionDue& due, const std::string& by) {
  const std::int64_t now_us = core.now_us();
  Result<void> failure;
  std::size_t erased = 0;
  const std::int64_t before_us = rule.erase_months ? store::monthsBefore(now_us, *rule.erase_months) : 0;
  for (const RetentionDue::Trainee& one : due.trainees)
    if (auto done = eraseInactive(core, one.person.id, before_us, by); done)
      ++erased;
    else
      failure = done;
  auto ended = inTransaction(core, store::Way::Write, [&](Transaction& transaction) -> Result<void> {
    if (rule.recording_months)
      store::endWorkOnRecordings(
          transaction, store::attemptsWithWorkBefore(transaction, store::monthsBefore(now_us, *rule.recording_months)),
          now_us);
    core.audit(transaction, by, "apply retention", "",
               std::to_string(erased) + " trainees, " + std::to_string(due.attempts.size()) + " recordings");
    transaction.run("UPDATE retention SET waits_us = ?, applied_us = ?", now_us, now_us);
    return {};
  });
  return ended ? failure : ended;
}

/// Checks the permission of a user in a short transaction; what follows reads the whole log.
Result<void> permit(store::Session& session, const std::string& detail) {
  return session.write({.act = Act::ManageRetention, .detail = detail},
                       [](Transaction&, const Actor&) -> Result<void> { return {}; });
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

Result<RetentionDue> Retention::preview(const RetentionRule& rule) const {
  for (const auto& months : {rule.erase_months, rule.recording_months})
    if (auto ok = checkMonths(months); !ok) return tl::unexpected(ok.error());
  Core& core = by_.session()->core();
  if (auto ok = permit(*by_.session(), "preview"); !ok) return tl::unexpected(ok.error());
  auto due = inTransaction(core, store::Way::Read, [&](Transaction& transaction) -> Result<RetentionDue> {
    return dueNow(transaction, core, rule);
  });
  if (due) leaveKept(core, *due);
  return due;
}

Result<RetentionDue> Retention::deleteExpired() const {
  Core& core = by_.session()->core();
  if (auto ok = permit(*by_.session(), "apply"); !ok) return tl::unexpected(ok.error());
  RetentionRule rule;
  auto due = inTransaction(core, store::Way::Read, [&](Transaction& transaction) -> Result<RetentionDue> {
    rule = storedRule(transaction);
    return dueNow(transaction, core, rule);
  });
  if (!due) return due;
  leaveKept(core, *due);
  const auto applied = applyRule(core, rule, *due, by_.person().id);
  if (auto removed = removeDue(core, *due); !removed) return tl::unexpected(removed.error());
  if (!applied) return tl::unexpected(applied.error());
  return due;
}

Result<void> RetentionSchedule::applyIfDue() {
  Core& core = *store_.core_;
  const std::int64_t now_us = core.now_us();
  const auto waits_us = [](Transaction& transaction) -> Result<std::optional<std::int64_t>> {
    const auto row = transaction.row(
        "SELECT waits_us FROM retention WHERE erase_months IS NOT NULL OR recording_months IS NOT NULL");
    return row ? std::optional(row->number(0)) : std::nullopt;
  };
  const auto isTime = [&](const std::optional<std::int64_t>& since_us) {
    return since_us && (now_us - *since_us >= kRetentionPause_us || *since_us > now_us + kClockDifference_us);
  };
  // Most of the time nothing is due, and a transaction for writing would hold up others.
  const auto seen = inTransaction(core, store::Way::Read, waits_us);
  if (!seen) return tl::unexpected(seen.error());
  if (!isTime(*seen)) return {};
  RetentionRule rule;
  const auto mine = inTransaction(core, store::Way::Write, [&](Transaction& transaction) -> Result<bool> {
    const auto since_us = *waits_us(transaction);
    if (!isTime(since_us)) return false;  // another server was faster
    transaction.run("UPDATE retention SET waits_us = ?", now_us);
    rule = storedRule(transaction);
    const std::int64_t waited_us = now_us - *since_us;
    return waited_us >= kRetentionPause_us && waited_us <= kLongestPause_us;
  });
  if (!mine) return tl::unexpected(mine.error());
  if (!*mine) return {};
  auto due = inTransaction(core, store::Way::Read, [&](Transaction& transaction) -> Result<RetentionDue> {
    return dueNow(transaction, core, rule);
  });
  if (!due) return tl::unexpected(due.error());
  leaveKept(core, *due);
  return applyRule(core, rule, *due, "");
}

Result<FilesToDelete> RetentionSchedule::applyDaily() {
  using Attempts = std::vector<std::string>;
  if (auto done = applyIfDue(); !done) return tl::unexpected(done.error());
  Core& core = *store_.core_;
  std::int64_t applied_us = 0;
  auto attempts = inTransaction(core, store::Way::Read, [&](Transaction& transaction) -> Result<Attempts> {
    applied_us = transaction.number("SELECT applied_us FROM retention");
    const auto before_us = store::recordingsDeletedBefore_us(transaction);
    return applied_us != removed_us_ && before_us ? store::attemptsBefore(transaction, *before_us) : Attempts();
  });
  if (!attempts) return tl::unexpected(attempts.error());
  FilesToDelete files{.attempts = *std::move(attempts)};
  files.recordings = store::removeRecordings(core.recordings(), files.attempts);
  if (files.recordings) removed_us_ = applied_us;
  return files;
}

}  // namespace insonate
