#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/CurriculumStore.h>
#include <insonate/curriculum/Person.h>
#include <insonate/curriculum/SignedIn.h>

#include <string>
#include <utility>
#include <vector>

namespace insonate {

/// People and their passwords. A trainee sees themselves, an instructor also the people of cohorts that are theirs, an
/// administrator all. Passwords have 8 to 200 characters. On a workstation that belongs to a server, people are changed
/// on the server.
class PeopleStore {
 public:
  explicit PeopleStore(SignedIn by) : by_(std::move(by)) {}

  /// Themselves, or someone they may see.
  Result<Person> person(const std::string& id) const;
  /// Returns all people by name; administrators only.
  Result<std::vector<Person>> all() const;

  /// Adds a person, who must change `password` at the first sign-in. An administrator adds anyone; an instructor adds
  /// trainees to `cohort`, one of the instructor's own. An empty cohort means none, and is for administrators only.
  Result<Person> add(const NewPerson& person, const std::string& password, const std::string& cohort = "") const;
  /// Name, full name, e-mail, role and whether they are disabled; administrators only. The last administrator who can
  /// sign in stays one.
  Result<void> change(const Person& person) const;
  /// Changes full name and e-mail of the signed-in user.
  Result<void> changeOwnDetails(const std::string& fullName, const std::string& email) const;

  Result<void> changeOwnPassword(const std::string& old, const std::string& password) const;
  /// A password for someone else, who must change it at the next sign-in; also ends their lock-out. Instructors: for
  /// trainees of their cohorts.
  Result<void> resetPassword(const std::string& person, const std::string& password) const;

 private:
  SignedIn by_;
};

}  // namespace insonate
