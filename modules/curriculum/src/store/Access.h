#pragma once

#include "store/sql/Transaction.h"

#include <insonate/curriculum/Person.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace insonate::store {

/// All kinds of access to the curriculum database.
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
  ExportPerson,
  ErasePerson,
  ManageRetention,
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
  OpenTest,
  CloseTest,
  SeeOpenings,
  EnterTest,
  VoidAttempt,
  AcceptAttempt,
  ReadCurricula,
  SeeDrafts,
  WriteDrafts,
  Publish,
  FillForm,
  SeeForms,
  SeeCohortForms,
  WriteComment,
  RemoveComment,
  SeeComments,
  ReadComments,
  SeeAudit,
  SeeUploads,
  ManageWorkstations,
  LookAfterStore
};

/// People whose data a role may access by one kind of access.
enum class Reach {
  None,
  Self,  ///< the user's own data
  /// The user's own data, and data of learners in a cohort that the user teaches. If the access is to a cohort: a
  /// cohort that the user teaches.
  Taught,
  All,
};

/// Further conditions of a kind of access: flags of Rule::conditions.
enum Condition : unsigned {
  kUnlogged = 1,       ///< the access is not logged, since it discloses nothing about others
  kNotOneself = 2,     ///< access to the user's own data is forbidden
  kOnlyTrainees = 4,   ///< instructors have access to the data of trainees only
  kOnServer = 8,       ///< access is refused on a workstation that belongs to a server
  kOnSite = 32,        ///< access is refused on a workstation that reaches its server through the network
  kLoggedAlways = 64,  ///< access to the user's own data is logged, too
  kWholeCohort = 16,   ///< the access discloses data of all learners in a cohort; the number of learners is logged
};

/// Permission for one kind of access. Only the table rules() states permissions.
struct Rule {
  Act act;
  std::string_view words;  ///< name of the kind of access in the audit log: "see attempts"
  Reach guest, trainee, instructor, administrator;
  unsigned conditions = 0;

  constexpr bool has(Condition condition) const { return (conditions & condition) != 0; }
};

std::span<const Rule> rules();
const Rule& ruleOf(Act act);

/// A request for an access. If the request names an attempt, permission is checked for the data of the person who made
/// the attempt.
struct Request {
  Act act;
  std::string person{}, cohort{}, attempt{};
  std::string detail{};  ///< further text for the audit log
  /// true: a program repeats the request by itself, and one entry an hour stands for all permitted requests that would
  /// have the same entry. Refusals are logged each time.
  bool isLoggedHourly = false;
  std::span<const std::string> people{};  ///< further people whose data is accessed; the audit log names all of them
};

/// Ways of signing in. A user whom an identity provider has signed in needs no password of their own.
enum class SignInBy { Password, Provider };

struct Actor {
  std::string id{};  ///< user who makes the request (Person::id); "": a guest
  std::optional<Role> role{};
  std::int64_t passwordVersion = 0;  ///< version of the password with which the session was opened
  SignInBy by = SignInBy::Password;
};

struct Verdict {
  std::optional<Error> refusal{};
  bool logged = false;
  std::string person{};                    ///< owner of the accessed data; for an attempt, the person who made it
  std::optional<std::int64_t> learners{};  ///< number of learners in the cohort; set for kinds of access with
                                           ///< kWholeCohort
};

/// Looks up the actor's present role, decides whether the request is permitted, and finds the owner of the data.
Verdict decide(Transaction& transaction, Actor& actor, const Request& request);

}  // namespace insonate::store
