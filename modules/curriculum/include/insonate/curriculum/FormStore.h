#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/FormAgreement.h>
#include <insonate/curriculum/SignedIn.h>

#include <string>
#include <utility>
#include <vector>

namespace insonate {

/// Access to filled forms in the database, with the permissions of a signed-in user. Forms can be added, but neither
/// changed nor deleted. Users may fill in forms about themselves; instructors may also fill in forms about learners in
/// their cohorts (classes). A form can be read by the person concerned and by all who may see the person's attempts.
/// Raters see another rater's answers about an attempt only after submitting the same form themselves.
class FormStore {
 public:
  explicit FormStore(SignedIn by) : by_(std::move(by)) {}

  /// Adds a filled form and returns its id. Adding the same form again is no error; another form of the same kind by
  /// the same rater about the same attempt is refused.
  Result<std::string> add(const FilledForm& filled) const;
  /// Returns the filled forms about a person, in the order in which they were submitted.
  Result<std::vector<StoredForm>> listByPerson(const std::string& person) const;
  Result<std::vector<StoredForm>> listByAttempt(const std::string& attempt) const;
  /// Returns the filled forms with the name `form` about all learners of a cohort, in the order in which they were
  /// submitted.
  Result<std::vector<StoredForm>> listByCohort(const std::string& cohort, const std::string& form) const;
  /// Returns the agreement of raters on `form` over the attempts of a cohort. With few attempts, these numbers can
  /// disclose answers. For a reader who rates attempts by this form, the attempts that the reader has not rated are
  /// therefore left out.
  Result<FormAgreement> agreement(const std::string& cohort, const Form& form) const;

 private:
  SignedIn by_;
};

}  // namespace insonate
