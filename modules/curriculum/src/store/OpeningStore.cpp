#include "store/AuditChain.h"
#include "store/CurriculumRows.h"
#include "store/LockOut.h"
#include "store/OpeningRows.h"
#include "store/Passwords.h"
#include "store/PeopleRows.h"
#include "store/Session.h"
#include "store/Texts.h"

#include <insonate/curriculum/OpeningStore.h>

#include <QtCore/QString>

namespace insonate {
namespace {

using store::Act;
using store::Actor;
using store::Core;
using store::Row;
using store::Transaction;

constexpr qsizetype kShortestCode = 4, kLongestCode = 32;

/// Form in which codes are hashed and compared.
std::string plainCode(const std::string& typed) {
  return store::nameKey(QString::fromStdString(typed).trimmed().toStdString());
}

Result<void> checkCode(const std::string& code) {
  if (auto ok = store::checkTitle("The code", code); !ok) return ok;
  const auto letters = QString::fromStdString(plainCode(code)).size();
  if (code.empty() || (letters >= kShortestCode && letters <= kLongestCode)) return {};
  return fail("The code has " + std::to_string(letters) + " characters. Choose one of 4 to 32 characters.");
}

Result<void> checkOpening(const NewOpening& opening, std::int64_t start_us) {
  if (!opening.end_us && opening.code.empty())
    return fail("The opening has neither an end nor a code. State one of them, or both.");
  if (opening.end_us && *opening.end_us <= start_us)
    return fail("The end of the opening is not after its start and after the present time. State a later end.");
  return checkCode(opening.code);
}

/// Curriculum by which a class is taught; for everyone, the newest published version.
Result<Curriculum> curriculumFor(Transaction& transaction, const NewOpening& opening) {
  if (!opening.cohort.empty()) {
    if (auto ok = store::checkIsNotArchived(transaction, opening.cohort); !ok) return tl::unexpected(ok.error());
    const auto cohort =
        transaction.row("SELECT name, curriculum, curriculum_version FROM cohorts WHERE id = ?", opening.cohort);
    if (!cohort) return fail("There is no such class; reload the list of classes.");
    if (cohort->text(1).empty()) return fail("The class '" + cohort->text(0) + "' has no curriculum; set one.");
    return store::publishedCurriculum(transaction, cohort->text(1), cohort->count(2));
  }
  const auto newest = transaction.row("SELECT MAX(version) FROM curricula WHERE name = ?", opening.curriculum);
  if (!newest || newest->isNull(0))
    return fail("The curriculum '" + opening.curriculum + "' is not published; publish it first.");
  return store::publishedCurriculum(transaction, opening.curriculum, newest->count(0));
}

Result<std::string> testOf(const Curriculum& curriculum, const std::string& level) {
  std::string tests;
  for (const Level& one : curriculum.levels) {
    if (one.assistance != Assistance::Test) continue;
    if (one.name == level) return curriculum.name;
    tests += (tests.empty() ? "'" : ", '") + one.name + "'";
  }
  return fail("'" + level + "' is not a test of the curriculum '" + curriculum.name + "', which has " +
              (tests.empty() ? "no tests" : "the tests " + tests) + ". Only tests are opened.");
}

constexpr std::string_view kOpenings =
    "SELECT openings.id, cohort, curriculum, level, start_us, end_us, CASE WHEN code = '' THEN 0 ELSE 1 END, "
    "COALESCE(NULLIF(o.full_name, ''), o.name, opened_by), opened_us, closed_us, "
    "COALESCE(NULLIF(c.full_name, ''), c.name, closed_by, '') FROM openings "
    "LEFT JOIN people o ON o.id = opened_by LEFT JOIN people c ON c.id = closed_by ";

std::vector<TestOpening> openingsOf(const std::vector<Row>& rows) {
  std::vector<TestOpening> openings;
  for (const Row& row : rows)
    openings.push_back({row.text(0), row.text(1), row.text(2), row.text(3), row.number(4), row.time(5), row.truth(6),
                        row.text(7), row.number(8), row.time(9), row.text(10)});
  return openings;
}

Result<void> closeOpening(Transaction& transaction, const std::string& cohort, const std::string& opening,
                          const std::string& by, std::int64_t now_us) {
  const auto rows = transaction.rows(std::string(kOpenings) + "WHERE openings.id = ? AND cohort = ?", opening, cohort);
  if (rows.empty()) return fail("There is no such opening of a test; reload the list.");
  const OpeningState state = stateAt(openingsOf(rows).front(), now_us);
  if (state == OpeningState::Ended || state == OpeningState::Closed) return {};
  transaction.run("UPDATE openings SET closed_us = ?, closed_by = ? WHERE id = ?", now_us, by, opening);
  return {};
}

/// Sign-in names contain no blanks, so that no name is locked with the code of a test.
std::string lockOf(const std::string& person, const std::string& curriculum, const std::string& level) {
  return "test code " + person + " " + curriculum + " " + level;
}

/// A second window may have entered the same code meanwhile.
void enter(Transaction& transaction, const std::string& opening, const std::string& person, std::int64_t now_us) {
  if (!transaction.row("SELECT 1 FROM opening_entries WHERE opening = ? AND person = ?", opening, person))
    transaction.run("INSERT INTO opening_entries VALUES (?, ?, ?)", opening, person, now_us);
}

}  // namespace

OpeningState stateAt(const TestOpening& opening, std::int64_t now_us) {
  if (opening.closed_us && *opening.closed_us <= now_us) return OpeningState::Closed;
  if (opening.end_us && *opening.end_us <= now_us) return OpeningState::Ended;
  return now_us < opening.start_us ? OpeningState::Waiting : OpeningState::Open;
}

const char* nameOf(OpeningState state) {
  switch (state) {
    case OpeningState::Waiting:
      return "waiting";
    case OpeningState::Open:
      return "open";
    case OpeningState::Ended:
      return "ended";
    case OpeningState::Closed:
      break;
  }
  return "closed";
}

Result<TestOpening> OpeningStore::open(const NewOpening& opening) const {
  const Core& core = by_.session()->core();
  const std::int64_t now_us = core.now_us(), start_us = std::max(now_us, opening.start_us.value_or(now_us));
  if (auto ok = checkOpening(opening, start_us); !ok) return tl::unexpected(ok.error());
  const auto hashed = opening.code.empty() ? Result<std::string>(std::string())
                                           : store::hashedPassword(plainCode(opening.code), core.passwordCost());
  if (!hashed) return tl::unexpected(hashed.error());
  const std::string id = store::freshUuid();
  return by_.session()->write(
      {.act = Act::OpenTest, .cohort = opening.cohort, .detail = id + " of level " + store::forLog(opening.level)},
      [&](Transaction& transaction, const Actor& actor) -> Result<TestOpening> {
        const auto curriculum = curriculumFor(transaction, opening);
        if (!curriculum) return tl::unexpected(curriculum.error());
        const auto name = testOf(*curriculum, opening.level);
        if (!name) return tl::unexpected(name.error());
        transaction.run("INSERT INTO openings VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, NULL, NULL)", id, opening.cohort,
                        *name, opening.level, start_us, opening.end_us, *hashed, actor.id, now_us);
        const auto rows = transaction.rows(std::string(kOpenings) + "WHERE openings.id = ?", id);
        return rows.empty() ? TestOpening() : openingsOf(rows).front();
      });
}

Result<void> OpeningStore::close(const std::string& cohort, const std::string& opening) const {
  return by_.session()->write(
      {.act = Act::CloseTest, .cohort = cohort, .detail = opening}, [&](Transaction& transaction, const Actor& actor) {
        return closeOpening(transaction, cohort, opening, actor.id, by_.session()->core().now_us());
      });
}

Result<std::vector<TestOpening>> OpeningStore::listByCohort(const std::string& cohort) const {
  return by_.session()->read(
      {.act = Act::SeeOpenings, .cohort = cohort},
      [&](Transaction& transaction, const Actor&) -> Result<std::vector<TestOpening>> {
        return openingsOf(transaction.rows(
            std::string(kOpenings) + "WHERE cohort = ? OR cohort = '' ORDER BY start_us DESC, openings.id", cohort));
      });
}

Result<std::vector<TestOpening>> OpeningStore::all() const {
  return by_.session()->read(
      {.act = Act::SeeOpenings}, [&](Transaction& transaction, const Actor&) -> Result<std::vector<TestOpening>> {
        return openingsOf(transaction.rows(std::string(kOpenings) + "ORDER BY start_us DESC, openings.id"));
      });
}

Result<TestAdmission> OpeningStore::admission(const std::string& curriculum, const std::string& level) const {
  const std::string& person = by_.person().id;
  return by_.session()->read(
      {.act = Act::EnterTest, .person = person}, [&](Transaction& transaction, const Actor&) -> Result<TestAdmission> {
        return store::admissionAt(transaction, person, curriculum, level, by_.session()->core().now_us());
      });
}

/// The try is counted before the code is compared, so that simultaneous tries gain nothing.
Result<TestAdmission> OpeningStore::enterCode(const std::string& curriculum, const std::string& level,
                                              const std::string& code) const {
  const Core& core = by_.session()->core();
  const std::string& person = by_.person().id;
  const std::string lock = lockOf(person, curriculum, level);
  const store::Request request{.act = Act::EnterTest, .person = person};
  std::int64_t wait_s = 0;
  const auto coded = by_.session()->write(
      request, [&](Transaction& transaction, const Actor&) -> Result<std::vector<store::CodedOpening>> {
        auto found = store::codedOpenings(transaction, person, curriculum, level, core.now_us());
        if (!found.empty()) wait_s = store::secondsLockedAfterTry(transaction, lock, core.moment());
        return found;
      });
  if (!coded) return tl::unexpected(coded.error());
  if (coded->empty()) return this->admission(curriculum, level);
  if (wait_s > 0) return fail("There were too many wrong codes. Try again in " + std::to_string(wait_s) + " s.");
  std::string entered;
  for (const store::CodedOpening& one : *coded)
    if (store::fitsPassword(plainCode(code), one.hashed)) entered = one.id;
  auto admission = by_.session()->write(request, [&](Transaction& transaction, const Actor&) -> Result<TestAdmission> {
    if (!entered.empty()) enter(transaction, entered, person, core.now_us());
    if (!entered.empty()) store::resetFailures(transaction, lock);
    core.audit(transaction, person, "enter test code", person,
               entered.empty() ? "of level " + store::forLog(level) : entered, !entered.empty());
    return store::admissionAt(transaction, person, curriculum, level, core.now_us());
  });
  if (admission && entered.empty()) return fail("The code is wrong. Ask the instructor for the code of this test.");
  return admission;
}

}  // namespace insonate
