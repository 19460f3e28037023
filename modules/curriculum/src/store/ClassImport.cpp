#include "store/Passwords.h"
#include "store/PeopleRows.h"
#include "store/Session.h"
#include "store/Texts.h"

#include <insonate/curriculum/ClassImport.h>

#include <algorithm>
#include <set>

namespace insonate {
namespace {

using store::Act;
using store::Actor;
using store::Row;
using store::Transaction;
using Step = ClassImportRow::Step;

std::string atLine(int line, const std::string& sentence) {
  return "Line " + std::to_string(line) + ": " + sentence;
}

ClassImportRow refused(const ClassListEntry& entry, const std::string& sentence) {
  return {.line = entry.line, .person = entry.person, .step = Step::Refuse, .why = atLine(entry.line, sentence)};
}

/// People whom the user may see: all for an administrator, those of their own cohorts for an instructor.
std::vector<Person> visiblePeople(Transaction& transaction, const Actor& actor) {
  std::vector<Person> people;
  for (const Row& row :
       transaction.rows("SELECT " INSONATE_PERSON_COLUMNS
                        " FROM people WHERE ? = 1 OR id IN (SELECT theirs.person FROM memberships own JOIN memberships "
                        "theirs ON theirs.cohort = own.cohort WHERE own.person = ? AND own.teaches = 1)",
                        actor.role == Role::Administrator, actor.id))
    people.push_back(store::personOf(row));
  return people;
}

/// E-mail addresses of all accounts, also of those that the instructor cannot see, as nameKey() writes them.
std::set<std::string> usedEmails(Transaction& transaction) {
  std::set<std::string> used;
  for (const Row& row : transaction.rows("SELECT email FROM people WHERE email <> ''"))
    used.insert(store::nameKey(row.text(0)));
  return used;
}

/// Fails if an account has the e-mail address: two accounts would split the attempts of one person.
Result<void> checkEmailIsFree(const std::set<std::string>& used, const std::string& email) {
  if (email.empty() || !used.contains(store::nameKey(email))) return {};
  return fail("The e-mail address " + email +
              " belongs to an account that already exists. Only an administrator can add this person to a class.");
}

/// The name or e-mail address of a person whom the instructor cannot see may be in use.
ClassImportRow plannedNew(Transaction& transaction, const std::set<std::string>& used, const ClassListEntry& entry) {
  auto free = store::checkNameIsFree(transaction, Person{.name = entry.person.name});
  if (free) free = checkEmailIsFree(used, entry.person.email);
  return free ? ClassImportRow{.line = entry.line, .person = entry.person, .step = Step::Add}
              : refused(entry, free.error().message);
}

ClassImportRow plannedKnown(const Actor& actor, const ClassListMatch::Known& known, bool isThere) {
  const auto& [entry, person] = known;
  if (!isThere && actor.role != Role::Administrator)
    return refused(entry,
                   person.fullName + " already has an account. Only an administrator can add this person to a class.");
  if (person.disabled)
    return refused(entry, "The account of " + person.fullName +
                              (isThere ? ", who is already in the class," : std::string()) +
                              " is disabled. An administrator can enable it; then import the list again.");
  return {
      .line = entry.line, .person = entry.person, .step = isThere ? Step::AlreadyThere : Step::Join, .id = person.id};
}

std::vector<ClassImportRow> planned(Transaction& transaction, const Actor& actor, const std::string& cohort,
                                    const ClassListMatch& match) {
  std::vector<ClassImportRow> rows;
  for (const ClassListError& error : match.errors)
    rows.push_back({.line = error.line, .person = error.person, .step = Step::Refuse, .why = error.sentence});
  const std::set<std::string> used = usedEmails(transaction);
  for (const ClassListEntry& entry : match.added) rows.push_back(plannedNew(transaction, used, entry));
  std::set<std::string> there;
  for (const Row& row : transaction.rows("SELECT person FROM memberships WHERE cohort = ?", cohort))
    there.insert(row.text(0));
  for (const ClassListMatch::Known& known : match.known)
    rows.push_back(plannedKnown(actor, known, there.contains(known.person.id)));
  std::ranges::stable_sort(rows, {}, &ClassImportRow::line);
  return rows;
}

Result<std::vector<std::string>> hashesOf(std::span<const FirstPassword> passwords, PasswordCost cost,
                                          const Progress& progress) {
  std::vector<std::string> hashes;
  for (const FirstPassword& one : passwords) {
    const double done = static_cast<double>(hashes.size()) / static_cast<double>(passwords.size());
    if (!report(progress, "Keeping first passwords", done)) return fail(std::string(kCancelled));
    auto hashed = store::checkedAndHashed(one.password, cost);
    if (!hashed) return tl::unexpected(hashed.error());
    hashes.push_back(std::move(*hashed));
  }
  return hashes;
}

Result<void> take(store::Session& session, Transaction& transaction, const std::string& cohort,
                  const ClassImportRow& row, const std::string* hashed) {
  if (hashed) {
    const std::string id = store::freshUuid();
    const store::Request request{.act = Act::AddTrainee, .cohort = cohort, .detail = id + ", trainee"};
    if (auto ok = session.also(transaction, request); !ok) return ok;
    const auto added = store::insertPerson(transaction, id, row.person, *hashed, true);
    return added ? store::putIntoCohort(transaction, cohort, *added, false) : tl::unexpected(added.error());
  }
  const store::Request request{.act = Act::ChangeCohorts, .person = row.id, .cohort = cohort, .detail = "learns"};
  if (auto ok = session.also(transaction, request); !ok) return ok;
  const auto known = store::findPerson(transaction, row.id);
  if (!known) return fail("This person no longer exists.");
  return store::putIntoCohort(transaction, cohort, *known, false);
}

}  // namespace

Result<std::vector<ClassImportRow>> ClassImport::plan(const std::string& cohort, const ClassList& list) const {
  return by_.session()->read({.act = Act::SeeMembers, .cohort = cohort},
                             [&](Transaction& transaction, const Actor& actor) -> Result<std::vector<ClassImportRow>> {
                               if (auto ok = store::checkIsNotArchived(transaction, cohort); !ok)
                                 return tl::unexpected(ok.error());
                               return planned(transaction, actor, cohort,
                                              matchClassList(list, visiblePeople(transaction, actor)));
                             });
}

std::vector<FirstPassword> ClassImport::passwordsFor(std::span<const ClassImportRow> plan) {
  std::vector<FirstPassword> passwords;
  for (const ClassImportRow& row : plan)
    if (row.step == Step::Add) passwords.push_back({row.person, generateFirstPassword()});
  return passwords;
}

Result<void> ClassImport::apply(const std::string& cohort, std::span<const ClassImportRow> plan,
                                std::span<const FirstPassword> passwords, const Progress& progress) const {
  store::Session& session = *by_.session();
  const auto adds = std::ranges::count(plan, Step::Add, &ClassImportRow::step);
  const auto joins = std::ranges::count(plan, Step::Join, &ClassImportRow::step);
  if (static_cast<std::size_t>(adds) != passwords.size())
    return fail("There are " + std::to_string(passwords.size()) + " passwords for " + std::to_string(adds) +
                " new people; generate them again from this plan.");
  const auto hashes = hashesOf(passwords, session.core().passwordCost(), progress);
  if (!hashes) return tl::unexpected(hashes.error());
  const std::string detail = "class list, " + std::to_string(adds) + " new, " + std::to_string(joins) + " known";
  // The request names the most restricted of the acts involved, so that a refusal is logged.
  return session.write({.act = joins > 0 ? Act::ChangeCohorts : Act::AddTrainee, .cohort = cohort, .detail = detail},
                       [&](Transaction& transaction, const Actor&) -> Result<void> {
                         const std::set<std::string> used = usedEmails(transaction);
                         auto hashed = hashes->begin();
                         for (const ClassImportRow& row : plan) {
                           if (row.step != Step::Add && row.step != Step::Join) continue;
                           const std::string* own = row.step == Step::Add ? &*hashed++ : nullptr;
                           auto done = own ? checkEmailIsFree(used, row.person.email) : Result<void>{};
                           if (done) done = take(session, transaction, cohort, row, own);
                           if (!done)
                             return fail(atLine(row.line, done.error().message) + " Nobody was added; check the list.");
                         }
                         return {};
                       });
}

}  // namespace insonate
