#include "store/AttemptRows.h"
#include "store/CurriculumRows.h"
#include "store/PeopleRows.h"
#include "store/Session.h"
#include "store/StandingRows.h"
#include "store/Texts.h"

#include <insonate/curriculum/CohortStore.h>

namespace insonate {
namespace {

using store::Act;
using store::Actor;
using store::Row;
using store::Transaction;

/// Columns that cohortOf() reads.
#define INSONATE_COHORT_COLUMNS \
  "cohorts.id, cohorts.name, cohorts.curriculum, cohorts.curriculum_version, cohorts.archived"

Cohort cohortOf(const Row& row) {
  return {.id = row.text(0),
          .name = row.text(1),
          .curriculum = row.text(2),
          .curriculumVersion = row.count(3),
          .archived = row.truth(4)};
}

tl::unexpected<Error> unknownCohort() {
  return fail("There is no such class; reload the list.");
}

Result<void> checkName(Transaction& transaction, const std::string& id, const std::string& name) {
  if (auto ok = store::checkTitle("The class's name", name); !ok) return ok;
  if (store::nameKey(name).empty()) return fail("The class has no name; type one.");
  if (transaction.number("SELECT COUNT(*) FROM cohorts WHERE name_key = ? AND id <> ?", store::nameKey(name), id) > 0)
    return fail("There is a class named '" + name + "' already; choose another name.");
  return {};
}

void closeOpeningsOf(Transaction& transaction, const std::string& cohort, const Actor& actor, std::int64_t now_us) {
  transaction.run(
      "UPDATE openings SET closed_us = ?, closed_by = ? WHERE cohort = ? AND closed_us IS NULL AND (end_us IS NULL OR "
      "end_us > ?)",
      now_us, actor.id, cohort, now_us);
}

/// Members, their attempts, and their standing when it was last computed for the cohort's curriculum. A separate query
/// subtracts attempts that do not count: a single one would read the metrics of each attempt, which the index lacks.
constexpr std::string_view kMembers =
    "SELECT " INSONATE_PERSON_COLUMNS
    ", memberships.teaches, done.attempts - (SELECT COUNT(*) FROM attempts WHERE attempts.person = people.id "
    "AND voided_us IS NULL AND " INSONATE_UNTRIED
    "), done.changes, last.begun_us, last.level, " INSONATE_STANDING_COLUMNS
    " FROM memberships JOIN people ON people.id = memberships.person JOIN cohorts ON cohorts.id = memberships.cohort "
    "LEFT JOIN (SELECT attempts.person, MAX(arrival) AS last, "
    "SUM(CASE WHEN state <> 'open' AND voided_us IS NULL THEN 1 ELSE 0 END) AS attempts, " INSONATE_CHANGES
    " AS changes "
    "FROM attempts WHERE attempts.person IN (SELECT person FROM memberships WHERE cohort = ? AND teaches = 0) "
    "GROUP BY attempts.person) AS done ON done.person = people.id AND memberships.teaches = 0 "
    "LEFT JOIN attempts AS last ON last.arrival = done.last "
    "LEFT JOIN standings ON standings.person = people.id AND memberships.teaches = 0 "
    "AND standings.curriculum = cohorts.curriculum AND standings.curriculum_version = cohorts.curriculum_version "
    "WHERE memberships.cohort = ? ORDER BY memberships.teaches DESC, CASE WHEN people.full_name = '' THEN people.name "
    "ELSE people.full_name "
    "END, people.name_key";

Member memberOf(const Row& row, std::int64_t now_us) {
  constexpr std::size_t kStanding = 11;
  Member member{.person = store::personOf(row),
                .teaches = row.truth(6),
                .attempts = row.count(7),
                .changes = row.number(8),
                .lastAttempt_us = row.time(9),
                .lastLevel = row.text(10)};
  if (row.isNull(kStanding)) return member;
  member.standing = store::standingFrom(row, kStanding);
  member.standingIsCurrent = store::isCurrent(row, kStanding, member.changes, now_us);
  return member;
}

}  // namespace

Result<std::vector<Cohort>> CohortStore::cohorts() const {
  return by_.session()->read(
      {.act = Act::SeeOwnCohorts}, [&](Transaction& transaction, const Actor& actor) -> Result<std::vector<Cohort>> {
        std::vector<Cohort> cohorts;
        for (const Row& row : transaction.rows(
                 "SELECT " INSONATE_COHORT_COLUMNS " FROM cohorts WHERE ? = 1 OR EXISTS "
                 "(SELECT 1 FROM memberships WHERE cohort = cohorts.id AND person = ?) ORDER BY archived, name_key",
                 actor.role == Role::Administrator, actor.id))
          cohorts.push_back(cohortOf(row));
        return cohorts;
      });
}

Result<std::vector<Member>> CohortStore::members(const std::string& cohort) const {
  return by_.session()->read({.act = Act::SeeMembers, .cohort = cohort},
                             [&](Transaction& transaction, const Actor&) -> Result<std::vector<Member>> {
                               const std::int64_t now_us = by_.session()->core().now_us();
                               std::vector<Member> members;
                               for (const Row& row : transaction.rows(kMembers, cohort, cohort))
                                 members.push_back(memberOf(row, now_us));
                               return members;
                             });
}

Result<std::vector<Membership>> CohortStore::listByPerson(const std::string& person) const {
  return by_.session()->read(
      {.act = Act::SeePerson, .person = person},
      [&](Transaction& transaction, const Actor& actor) -> Result<std::vector<Membership>> {
        std::vector<Membership> memberships;
        for (const Row& row : transaction.rows(
                 "SELECT " INSONATE_COHORT_COLUMNS ", theirs.teaches FROM memberships AS theirs JOIN "
                 "cohorts ON cohorts.id = theirs.cohort WHERE theirs.person = ? AND (? = 1 OR theirs.person = ? OR "
                 "EXISTS (SELECT 1 FROM memberships AS own WHERE own.cohort = cohorts.id AND own.person = ? AND "
                 "own.teaches = 1)) ORDER BY archived, name_key",
                 person, actor.role == Role::Administrator, actor.id, actor.id))
          memberships.push_back({.cohort = cohortOf(row), .teaches = row.truth(5)});
        return memberships;
      });
}

Result<Cohort> CohortStore::add(const std::string& name) const {
  return by_.session()->write(
      {.act = Act::ChangeCohorts, .detail = "add"}, [&](Transaction& transaction, const Actor&) -> Result<Cohort> {
        const Cohort cohort{.id = store::freshUuid(), .name = name};
        if (auto ok = checkName(transaction, cohort.id, name); !ok) return tl::unexpected(ok.error());
        transaction.run("INSERT INTO cohorts VALUES (?, ?, ?, '', 0, 0)", cohort.id, name, store::nameKey(name));
        return cohort;
      });
}

Result<void> CohortStore::rename(const std::string& cohort, const std::string& name) const {
  return by_.session()->write({.act = Act::ChangeCohorts, .cohort = cohort, .detail = "rename"},
                              [&](Transaction& transaction, const Actor&) -> Result<void> {
                                if (auto ok = checkName(transaction, cohort, name); !ok) return ok;
                                if (transaction.run("UPDATE cohorts SET name = ?, name_key = ? WHERE id = ?", name,
                                                    store::nameKey(name), cohort) != 1)
                                  return unknownCohort();
                                return {};
                              });
}

Result<void> CohortStore::archive(const std::string& cohort, bool archived) const {
  const std::int64_t now_us = by_.session()->core().now_us();
  return by_.session()->write(
      {.act = Act::ChangeCohorts, .cohort = cohort, .detail = archived ? "archive" : "restore"},
      [&](Transaction& transaction, const Actor& actor) -> Result<void> {
        if (transaction.run("UPDATE cohorts SET archived = ? WHERE id = ?", archived, cohort) != 1)
          return unknownCohort();
        if (archived) closeOpeningsOf(transaction, cohort, actor, now_us);
        return {};
      });
}

Result<void> CohortStore::remove(const std::string& cohort, const std::string& name) const {
  const std::int64_t now_us = by_.session()->core().now_us();
  return by_.session()->write(
      {.act = Act::ChangeCohorts, .cohort = cohort, .detail = "delete " + name},
      [&](Transaction& transaction, const Actor& actor) -> Result<void> {
        const auto found = transaction.row("SELECT name_key FROM cohorts WHERE id = ?", cohort);
        if (!found) return unknownCohort();
        if (found->text(0) != store::nameKey(name))
          return fail("'" + name + "' is not the name of this class. Enter the name as the page shows it.");
        closeOpeningsOf(transaction, cohort, actor, now_us);
        transaction.run("DELETE FROM memberships WHERE cohort = ?", cohort);
        transaction.run("DELETE FROM cohorts WHERE id = ?", cohort);
        return {};
      });
}

Result<void> CohortStore::join(const std::string& cohort, const std::string& person, bool teaches) const {
  return by_.session()->write(
      {.act = Act::ChangeCohorts, .person = person, .cohort = cohort, .detail = teaches ? "teaches" : "learns"},
      [&](Transaction& transaction, const Actor&) -> Result<void> {
        const auto found = store::findPerson(transaction, person);
        if (!found) return fail("There is no such person; reload the list.");
        return store::putIntoCohort(transaction, cohort, *found, teaches);
      });
}

Result<void> CohortStore::leave(const std::string& cohort, const std::string& person) const {
  return by_.session()->write(
      {.act = Act::RemoveMember, .person = person, .cohort = cohort},
      [&](Transaction& transaction, const Actor&) -> Result<void> {
        if (transaction.run("DELETE FROM memberships WHERE cohort = ? AND person = ?", cohort, person) != 1)
          return fail("This person is not in this class; reload the list.");
        return {};
      });
}

Result<void> CohortStore::setCurriculum(const std::string& cohort, const std::string& curriculum, int version) const {
  return by_.session()->write(
      {.act = Act::SetCurriculum, .cohort = cohort, .detail = curriculum + " " + std::to_string(version)},
      [&](Transaction& transaction, const Actor&) -> Result<void> {
        if (auto ok = store::checkIsNotArchived(transaction, cohort); !ok) return ok;
        if (!transaction.row("SELECT 1 FROM curricula WHERE name = ? AND version = ?", curriculum, version))
          return fail("Version " + std::to_string(version) + " of the curriculum '" + curriculum +
                      "' is not published; publish it first.");
        if (transaction.run("UPDATE cohorts SET curriculum = ?, curriculum_version = ? WHERE id = ?", curriculum,
                            version, cohort) != 1)
          return unknownCohort();
        return {};
      });
}

Result<std::map<std::string, Standing>> CohortStore::standings(const std::string& cohort,
                                                               std::span<const std::string> people) const {
  using Standings = std::map<std::string, Standing>;
  const std::int64_t now_us = by_.session()->core().now_us();
  return by_.session()->write(
      {.act = Act::SeeStandings, .cohort = cohort, .people = people},
      [&](Transaction& transaction, const Actor&) -> Result<Standings> {
        const auto row = transaction.row("SELECT " INSONATE_COHORT_COLUMNS " FROM cohorts WHERE id = ?", cohort);
        if (!row) return unknownCohort();
        const Cohort taught = cohortOf(*row);
        if (taught.curriculum.empty()) return fail("The class '" + taught.name + "' has no curriculum; set one.");
        const auto curriculum = store::publishedCurriculum(transaction, taught.curriculum, taught.curriculumVersion);
        if (!curriculum) return tl::unexpected(curriculum.error());
        Standings standings;
        for (const std::string& person : people)
          if (transaction.row("SELECT 1 FROM memberships WHERE cohort = ? AND person = ? AND teaches = 0", cohort,
                              person))
            standings[person] = store::currentStanding(transaction, person, *curriculum, now_us);
        return standings;
      });
}

}  // namespace insonate
