#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/CurriculumStore.h>
#include <insonate/curriculum/Person.h>
#include <insonate/curriculum/SignedIn.h>

#include <string>
#include <utility>
#include <vector>

namespace insonate {

/// Access to accounts and passwords in the database, with the permissions of a signed-in user. Trainees see themselves;
/// instructors also see the people in their cohorts; administrators see everyone. Passwords have 8 to 200 characters.
/// If the workstation belongs to a server, people can be changed on the server only.
class PeopleStore {
 public:
  explicit PeopleStore(SignedIn by) : by_(std::move(by)) {}

  /// Returns the data of the signed-in user, or of a person whom the user may see.
  Result<Person> person(const std::string& id) const;
  /// Returns all people, sorted by name; administrators only.
  Result<std::vector<Person>> all() const;

  /// Adds a person, who must change `password` at the first sign-in. An administrator may add anyone; an instructor may
  /// add trainees to `cohort`, which must be the instructor's own. With an empty `cohort`, which only administrators
  /// may pass, the person joins no cohort. Fails if an account has the same name or e-mail address, ignoring case.
  Result<Person> add(const NewPerson& person, const std::string& password, const std::string& cohort = "") const;
  /// Changes a person's name, full name, e-mail, role and disabled state; administrators only. Fails if no
  /// administrator who can sign in would remain.
  Result<void> change(const Person& person) const;
  /// Changes full name and e-mail of the signed-in user.
  Result<void> changeOwnDetails(const std::string& fullName, const std::string& email) const;

  Result<void> changeOwnPassword(const std::string& old, const std::string& password) const;
  /// Makes a token with which the user can sign in without a password, on a computer to which only this user has
  /// access. Keep the token in a file that only its owner can read; the database stores a hash of the token. A change
  /// of the password revokes the token.
  Result<std::string> staySignedIn() const;
  /// Revokes all tokens of the signed-in user.
  Result<void> revokeTokens() const;
  /// Sets a password for another person, who must change the password at the next sign-in. Also unlocks the name after
  /// failed sign-ins. Allowed to administrators, and to instructors for trainees of their cohorts.
  Result<void> resetPassword(const std::string& person, const std::string& password) const;

 private:
  SignedIn by_;
};

}  // namespace insonate
