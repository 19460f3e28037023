#pragma once

#include "store/sql/Transaction.h"

#include <insonate/curriculum/Person.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace insonate::store {

/// All kinds of access to a store.
enum class Act {
  SeePerson,
  SeeAllPeople,
  AddPerson,
  AddTrainee,
  ChangePerson,
  ChangeOwnDetails,
  ChangeOwnPassword,
  StaySignedIn,
  ResetPassword,
  SeeOwnCohorts,
  SeeMembers,
  SeeStandings,
  ChangeCohorts,
  RemoveMember,
  SetCurriculum,
  MakeAttempt,
  SeeAttempts,
  SeeCohortAttempts,
  FindRecording,
  VoidAttempt,
  AcceptAttempt,
  ReadCurricula,
  SeeDrafts,
  WriteDrafts,
  Publish,
  FillForm,
  SeeForms,
  SeeCohortForms,
  SeeAudit,
  SeeUploads,
  LookAfterStore
};

/// People whom an act may concern.
enum class Reach {
  None,
  Self,    ///< the user's own data
  Taught,  ///< also data of learners in a cohort that the user teaches; for acts on a cohort: a cohort that the user
           ///< teaches
  All,
};

/// Further conditions of an act.
enum Condition : unsigned {
  kUnlogged = 1,      ///< discloses nothing about others; is not logged
  kNotOneself = 2,    ///< forbidden on the user's own data
  kOnlyTrainees = 4,  ///< instructors may do this to trainees only
  kOnServer = 8,      ///< done on the server if the store belongs to one
  kWholeCohort = 16,  ///< discloses data of all learners in a cohort: their number is logged
};

/// Permission for one act. The table of rules alone states which role may perform which act.
struct Rule {
  Act act;
  std::string_view words;  ///< name in the audit log: "see attempts"
  Reach guest, trainee, instructor, administrator;
  unsigned conditions = 0;

  constexpr bool has(Condition condition) const { return (conditions & condition) != 0; }
};

std::span<const Rule> rules();
const Rule& ruleOf(Act act);

/// A request to perform an act. If it names an attempt, the permission is checked for the person who made that attempt.
struct Request {
  Act act;
  std::string person{}, cohort{}, attempt{};
  std::string detail{};                   ///< for the audit log
  std::span<const std::string> people{};  ///< further people concerned; all are named in the audit log
};

struct Actor {
  std::string id{};  ///< "": a guest
  std::optional<Role> role{};
  std::int64_t passwordVersion = 0;  ///< version of the password with which the session was opened
};

struct Verdict {
  std::optional<Error> refusal{};
  bool logged = false;
  std::string person{};                    ///< owner of the data; for an attempt, the person who made it
  std::optional<std::int64_t> learners{};  ///< number of learners, for a kWholeCohort act
};

/// Looks up the actor's present role, decides whether the request is permitted, and finds the owner of the data.
Verdict decide(Transaction& transaction, Actor& actor, const Request& request);

}  // namespace insonate::store
