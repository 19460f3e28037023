#include "store/Access.h"

#include "store/Names.h"

#include <array>

namespace insonate::store {
namespace {

using enum Act;
using enum Reach;

// clang-format off
constexpr std::array kRules{
    //   act                words                     guest trainee instructor administrator
    Rule{SeePerson,         "see person",             None, Self,   Taught,    All},
    Rule{SeeAllPeople,      "see all people",         None, None,   None,      All},
    Rule{AddPerson,         "add person",             None, None,   None,      All, kOnServer},
    Rule{AddTrainee,        "add trainee",            None, None,   Taught,    All, kOnServer},
    Rule{ChangePerson,      "change person",          None, None,   None,      All, kOnServer},
    Rule{ChangeOwnDetails,  "change own details",     None, Self,   Self,      Self, kOnServer},
    Rule{ChangeOwnPassword, "change own password",    None, Self,   Self,      Self},
    Rule{StaySignedIn,      "stay signed in",         None, Self,   Self,      Self},
    Rule{ResetPassword,     "reset password",         None, None,   Taught,    All, kNotOneself | kOnlyTrainees | kOnServer},
    Rule{ExportPerson,      "export person",          None, Self,   Self,      All, kLoggedAlways},
    Rule{ErasePerson,       "erase person",           None, None,   None,      All, kNotOneself | kOnServer},
    Rule{ManageRetention,   "manage retention",       None, None,   None,      All, kOnServer},
    Rule{SeeOwnCohorts,     "see cohorts",            None, All,    All,       All, kUnlogged},
    Rule{SeeMembers,        "see members",            None, None,   Taught,    All, kWholeCohort},
    Rule{SeeStandings,      "see standings",          None, None,   Taught,    All},
    Rule{ChangeCohorts,     "change cohorts",         None, None,   None,      All, kOnServer},
    Rule{RemoveMember,      "remove member",          None, None,   Taught,    All, kOnServer},
    Rule{SetCurriculum,     "set curriculum",         None, None,   Taught,    All, kOnServer},
    Rule{MakeAttempt,       "make attempt",           None, Self,   Self,      Self},
    Rule{SeeAttempts,       "see attempts",           None, Self,   Taught,    All},
    Rule{SeeCohortAttempts, "see cohort's attempts",  None, None,   Taught,    All, kWholeCohort},
    Rule{FindRecording,     "find recording",         None, All,    All,       All, kUnlogged},
    Rule{OpenTest,          "open test",              None, None,   Taught,    All, kOnServer},
    Rule{CloseTest,         "close test",             None, None,   Taught,    All, kOnServer},
    Rule{SeeOpenings,       "see openings of tests",  None, None,   Taught,    All, kUnlogged},
    Rule{EnterTest,         "enter test",             None, Self,   Self,      Self},
    Rule{VoidAttempt,       "void attempt",           None, None,   Taught,    All, kNotOneself | kOnSite},
    Rule{AcceptAttempt,     "accept attempt",         None, None,   Taught,    All, kNotOneself | kOnSite},
    Rule{ReadCurricula,     "read curricula",         All,  All,    All,       All, kUnlogged},
    Rule{SeeDrafts,         "see drafts",             None, None,   All,       All, kUnlogged},
    Rule{WriteDrafts,       "write drafts",           None, None,   All,       All, kOnServer},
    Rule{Publish,           "publish curriculum",     None, None,   All,       All, kOnServer},
    Rule{FillForm,          "fill in form",           None, Self,   Taught,    All},
    Rule{SeeForms,          "see forms",              None, Self,   Taught,    All},
    Rule{SeeCohortForms,    "see cohort's forms",     None, None,   Taught,    All, kWholeCohort},
    Rule{WriteComment,      "write comment",          None, None,   Taught,    All, kNotOneself},
    Rule{RemoveComment,     "remove comment",         None, None,   Taught,    All},
    Rule{SeeComments,       "see comments",           None, Self,   Taught,    All},
    Rule{ReadComments,      "read own comments",      None, Self,   Self,      Self},
    Rule{SeeAudit,          "see audit log",          None, None,   None,      All},
    Rule{SeeUploads,        "see pending uploads",    None, None,   All,       All, kUnlogged},
    Rule{ManageWorkstations, "manage workstations",   None, None,   None,      All, kOnServer},
    Rule{LookAfterStore,    "look after store",       None, None,   None,      All},
};
// clang-format on

static_assert([] {
  for (std::size_t i = 0; i < kRules.size(); ++i)
    if (kRules[i].act != static_cast<Act>(i)) return false;
  return kRules.size() == static_cast<std::size_t>(LookAfterStore) + 1;
}());

Reach reachOf(const Rule& rule, const std::optional<Role>& role) {
  if (!role) return rule.guest;
  switch (*role) {
    case Role::Trainee:
      return rule.trainee;
    case Role::Instructor:
      return rule.instructor;
    case Role::Administrator:
      return rule.administrator;
  }
  return None;
}

/// Reads the current role of the person, so that a withdrawn role ends in an open session, too.
std::optional<Error> lookUp(Transaction& transaction, Actor& actor, Act act) {
  if (actor.id.empty()) return std::nullopt;
  const auto row = transaction.row(
      "SELECT role, disabled, version, must_change FROM people JOIN credentials ON person = id WHERE id = ?", actor.id);
  if (!row || row->truth(1)) return Error{"This account is disabled. Ask an administrator."};
  if (row->number(2) != actor.passwordVersion) return Error{"The password of this account was reset. Sign in again."};
  actor.role = roleNamed(row->text(0));
  if (row->truth(3) && actor.by == SignInBy::Password && act != ChangeOwnPassword)
    return Error{"Choose a password of your own first."};
  return std::nullopt;
}

bool teaches(Transaction& transaction, const std::string& actor, const std::string& cohort) {
  return transaction.number("SELECT COUNT(*) FROM memberships WHERE cohort = ? AND person = ? AND teaches = 1", cohort,
                            actor) > 0;
}

/// Tells whether the actor teaches the person in this cohort, or in any (empty).
bool teachesPerson(Transaction& transaction, const std::string& actor, const std::string& person,
                   const std::string& cohort, bool onlyTrainees) {
  return transaction.number(
             "SELECT COUNT(*) FROM memberships own JOIN memberships theirs ON theirs.cohort = own.cohort "
             "JOIN people ON people.id = theirs.person "
             "WHERE own.person = ? AND own.teaches = 1 AND theirs.person = ? AND theirs.teaches = 0 "
             "AND (? = '' OR own.cohort = ?) AND (? = 0 OR people.role = 'trainee')",
             actor, person, cohort, cohort, onlyTrainees) > 0;
}

bool isOwn(const Actor& actor, const Request& request, const std::string& person) {
  return !actor.id.empty() && person == actor.id && request.cohort.empty();
}

bool isWithin(Transaction& transaction, Reach reach, const Rule& rule, const Actor& actor, const Request& request,
              const std::string& person) {
  switch (reach) {
    case None:
      return false;
    case Self:
      return isOwn(actor, request, person);
    case Taught:
      if (isOwn(actor, request, person)) return true;
      if (person.empty()) return teaches(transaction, actor.id, request.cohort);
      return teachesPerson(transaction, actor.id, person, request.cohort, rule.has(kOnlyTrainees));
    case All:
      return true;
  }
  return false;
}

Error refusalOf(const Rule& rule, const Actor& actor) {
  if (!actor.role) return {"Sign in first: guests can neither store data nor see data of other people."};
  return {"You do not have the permission for this (" + std::string(rule.words) +
          "), or it does not exist. Ask an administrator for the permission."};
}

/// Refuses acts that are done on the server to which a workstation belongs.
std::optional<Error> refusalOnWorkstation(const Rule& rule, const std::string& server) {
  if (rule.has(kOnServer))
    return Error{"People, classes, curricula and openings of tests are stored on " + server + "; change them there."};
  if (rule.has(kOnSite) && server.starts_with("http"))
    return Error{"Attempts are voided and accepted on " + server + ", in a browser."};
  return std::nullopt;
}

}  // namespace

std::span<const Rule> rules() {
  return kRules;
}

const Rule& ruleOf(Act act) {
  return kRules[static_cast<std::size_t>(act)];
}

Verdict decide(Transaction& transaction, Actor& actor, const Request& request) {
  const Rule& rule = ruleOf(request.act);
  Verdict verdict{.person = request.person};
  if (!request.attempt.empty()) {
    const auto owner = transaction.row("SELECT person FROM attempts WHERE id = ?", request.attempt);
    verdict.person = owner ? owner->text(0) : "";
  }
  if (verdict.refusal = lookUp(transaction, actor, request.act); verdict.refusal) {
    verdict.logged = true;
    return verdict;
  }
  const bool own = isOwn(actor, request, verdict.person);
  const bool isUnknown = !request.attempt.empty() && verdict.person.empty();
  const Reach reach = reachOf(rule, actor.role);
  if (isUnknown || (own && rule.has(kNotOneself)) ||
      !isWithin(transaction, reach, rule, actor, request, verdict.person))
    verdict.refusal = refusalOf(rule, actor);
  else if (const auto site = transaction.row("SELECT server FROM site"); site && !site->text(0).empty())
    verdict.refusal = refusalOnWorkstation(rule, site->text(0));
  verdict.logged = verdict.refusal || rule.has(kLoggedAlways) || (!rule.has(kUnlogged) && !own);
  if (!verdict.refusal && rule.has(kWholeCohort))
    verdict.learners =
        transaction.number("SELECT COUNT(*) FROM memberships WHERE cohort = ? AND teaches = 0", request.cohort);
  return verdict;
}

}  // namespace insonate::store
