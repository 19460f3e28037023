#include "store/OpeningRows.h"

#include "store/AttemptRows.h"
#include "store/CurriculumRows.h"

#include <algorithm>
#include <array>
#include <utility>

namespace insonate::store {
namespace {

constexpr std::array<std::pair<TestConditions, std::string_view>, 6> kSittings{{
    {TestConditions::None, "none"},
    {TestConditions::Earlier, "earlier"},
    {TestConditions::Opened, "opened"},
    {TestConditions::SelfAdministered, "self"},
    {TestConditions::Practice, "practice"},
    {TestConditions::Undecided, "undecided"},
}};

/// Openings of a test for a person, open at a time.
#define INSONATE_OPEN_AT                                                                    \
  "FROM openings WHERE curriculum = ? AND level = ? AND (cohort = '' OR cohort IN (SELECT " \
  "cohort FROM memberships WHERE person = ? AND teaches = 0)) AND start_us <= ? AND "       \
  "(end_us IS NULL OR end_us > ?) AND (closed_us IS NULL OR closed_us > ?)"
/// The code was entered, or there is none.
#define INSONATE_ENTERED                                                                            \
  "(code = '' OR EXISTS (SELECT 1 FROM opening_entries WHERE opening = openings.id AND person = ? " \
  "AND entered_us <= ?))"

bool isIn(const Curriculum& curriculum, const std::string& level) {
  const Level* found = curriculum.level(level);
  return found && found->assistance == Assistance::Test;
}

/// A person without a class uses the built-in curriculum, which is not published.
bool isTest(Transaction& transaction, const AttemptFacts& facts) {
  if (facts.curriculum.empty()) return false;
  if (const auto published = publishedCurriculum(transaction, facts.curriculum, facts.curriculumVersion))
    return isIn(*published, facts.level);
  if (!std::ranges::count(curriculumPresetNames(), facts.curriculum)) return false;
  const auto builtIn = loadCurriculum(facts.curriculum);
  return builtIn && builtIn->version == facts.curriculumVersion && isIn(*builtIn, facts.level);
}

/// Tells whether a person is a learner in no class with another member. Archived classes do not count, since their
/// tests cannot be opened.
bool isAlone(Transaction& transaction, const std::string& person) {
  return transaction.number(
             "SELECT COUNT(*) FROM memberships own JOIN memberships other ON other.cohort = own.cohort AND "
             "other.person <> own.person JOIN cohorts ON cohorts.id = own.cohort AND archived = 0 WHERE own.person = ? "
             "AND own.teaches = 0",
             person) == 0;
}

}  // namespace

std::string_view nameOf(TestConditions testConditions) {
  return std::ranges::find(kSittings, testConditions, &decltype(kSittings)::value_type::first)->second;
}

/// A later program may have stored another name; such a test does not count here.
TestConditions sittingNamed(std::string_view name) {
  const auto known = std::ranges::find(kSittings, name, &decltype(kSittings)::value_type::second);
  return known == kSittings.end() ? TestConditions::Undecided : known->first;
}

TestConditions sittingAt(Transaction& transaction, const AttemptFacts& facts, std::int64_t at_us) {
  if (!isTest(transaction, facts)) return TestConditions::None;
  const std::string& person = facts.person;
  if (transaction.row("SELECT 1 " INSONATE_OPEN_AT " AND " INSONATE_ENTERED " LIMIT 1", facts.curriculum, facts.level,
                      person, at_us, at_us, at_us, person, at_us + kClocksDiffer_us))
    return TestConditions::Opened;
  return isAlone(transaction, person) ? TestConditions::SelfAdministered : TestConditions::Practice;
}

TestConditions sittingOnArrival(Transaction& transaction, const AttemptFacts& facts, std::int64_t now_us) {
  const TestConditions now = sittingAt(transaction, facts, now_us);
  if (now == TestConditions::None) return now;
  const bool isLate = facts.begun_us < now_us - kClocksDiffer_us;
  const bool mayHaveEnded = now == TestConditions::Practice && facts.begun_us < now_us &&
                            sittingAt(transaction, facts, facts.begun_us) == TestConditions::Opened;
  return isLate || mayHaveEnded ? TestConditions::Undecided : now;
}

TestAdmission admissionAt(Transaction& transaction, const std::string& person, const std::string& curriculum,
                          const std::string& level, std::int64_t now_us) {
  using enum TestAdmission::Kind;
  const auto open = transaction.rows("SELECT end_us " INSONATE_OPEN_AT " AND " INSONATE_ENTERED, curriculum, level,
                                     person, now_us, now_us, now_us, person, now_us);
  if (!open.empty()) {
    TestAdmission admission{.kind = Open, .end_us = 0};
    for (const Row& row : open)
      admission.end_us =
          row.isNull(0) || !admission.end_us ? std::nullopt : std::optional(std::max(*admission.end_us, row.number(0)));
    return admission;
  }
  if (isAlone(transaction, person)) return {.kind = SelfAdministered};
  if (!codedOpenings(transaction, person, curriculum, level, now_us).empty()) return {.kind = NeedsCode};
  const auto next = transaction.row(
      "SELECT MIN(start_us) FROM openings WHERE curriculum = ? AND level = ? AND (cohort = '' OR cohort IN (SELECT "
      "cohort FROM memberships WHERE person = ? AND teaches = 0)) AND start_us > ? AND closed_us IS NULL",
      curriculum, level, person, now_us);
  return {.kind = Closed, .next_us = next ? next->time(0) : std::nullopt};
}

std::vector<CodedOpening> codedOpenings(Transaction& transaction, const std::string& person,
                                        const std::string& curriculum, const std::string& level, std::int64_t now_us) {
  std::vector<CodedOpening> coded;
  for (const Row& row : transaction.rows("SELECT id, code " INSONATE_OPEN_AT " AND NOT " INSONATE_ENTERED, curriculum,
                                         level, person, now_us, now_us, now_us, person, now_us))
    coded.push_back({row.text(0), row.text(1)});
  return coded;
}

void mergeOpening(Transaction& here, const Row& row) {
  const auto own = here.row("SELECT closed_us FROM openings WHERE id = ?", row.text(0));
  const auto closedBy = row.isNull(9) ? std::nullopt : std::optional(row.text(9));
  if (!own)
    here.run("INSERT INTO openings VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)", row.text(0), row.text(1), row.text(2),
             row.text(3), row.number(4), row.time(5), row.text(6), row.text(7), row.number(8), closedBy, row.time(10));
  else if (own->isNull(0) && !row.isNull(10))
    here.run("UPDATE openings SET closed_by = ?, closed_us = ? WHERE id = ?", closedBy, row.time(10), row.text(0));
}

}  // namespace insonate::store
