#pragma once

#include "store/sql/Transaction.h"

#include <insonate/curriculum/Person.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace insonate::store {

/// All that can be asked of a store.
enum class Act {
  SeePerson,
  SeeAllPeople,
  AddPerson,
  AddTrainee,
  ChangePerson,
  ChangeOwnDetails,
  ChangeOwnPassword,
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
  Self,    ///< one's own data
  Taught,  ///< also of who learns in a cohort that one teaches; of an act on a cohort: one that one teaches
  All,
};

/// Further conditions of an act.
enum Condition : unsigned {
  kUnlogged = 1,      ///< tells nothing about others
  kNotOneself = 2,    ///< nobody does this to their own data
  kOnlyTrainees = 4,  ///< an instructor does this to trainees only
  kOnServer = 8,      ///< done on the server, where the store belongs to one
  kWholeCohort = 16,  ///< tells of all who learn in a cohort: their number is logged
};

/// Permission for one act. The table of rules is the only place that states who may do what.
struct Rule {
  Act act;
  std::string_view words;  ///< as in the audit log: "see attempts"
  Reach guest, trainee, instructor, administrator;
  unsigned conditions = 0;

  constexpr bool has(Condition condition) const { return (conditions & condition) != 0; }
};

std::span<const Rule> rules();
const Rule& ruleOf(Act act);

/// A request for an act. If it names an attempt, the permission is checked for the person who made that attempt.
struct Request {
  Act act;
  std::string person{}, cohort{}, attempt{};
  std::string detail{};                   ///< for the audit log
  std::span<const std::string> people{};  ///< who else it is about; all are named in the audit log
};

struct Actor {
  std::string id{};  ///< "": a guest
  std::optional<Role> role{};
  std::int64_t passwordVersion = 0;  ///< the session's
};

struct Verdict {
  std::optional<Error> refusal{};
  bool logged = false;
  std::string person{};                    ///< whose data it is, the attempt's person found
  std::optional<std::int64_t> learners{};  ///< how many, of a kWholeCohort act
};

/// Looks up who the actor is now, what they may do, and to whom the data belongs.
Verdict decide(Transaction& transaction, Actor& actor, const Request& request);

}  // namespace insonate::store
