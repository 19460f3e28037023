#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/FormAgreement.h>
#include <insonate/curriculum/SignedIn.h>

#include <string>
#include <utility>
#include <vector>

namespace insonate {

/// Stores filled-in forms, which are neither changed nor deleted. People fill in forms about themselves, and
/// instructors about learners in their cohorts. Visible to the person concerned and to those who may see the person's
/// attempts. Raters, whatever their role, see another rater's answers about an attempt only after submitting the same
/// form about it themselves.
class FormStore {
 public:
  explicit FormStore(SignedIn by) : by_(std::move(by)) {}

  /// Adds a form and returns its id. Adding the same form again is no error; another form of the same kind by the same
  /// rater about the same attempt is refused.
  Result<std::string> add(const FilledForm& filled) const;
  /// Returns the forms about a person, in the order of arrival.
  Result<std::vector<KeptForm>> ofPerson(const std::string& person) const;
  Result<std::vector<KeptForm>> ofAttempt(const std::string& attempt) const;
  /// Returns the forms of one kind about all learners of a cohort, in the order of arrival.
  Result<std::vector<KeptForm>> ofCohort(const std::string& cohort, const std::string& form) const;
  /// Returns the agreement of the raters over all attempts of a cohort. The figures disclose no rater's answers.
  Result<FormAgreement> agreement(const std::string& cohort, const Form& form) const;

 private:
  SignedIn by_;
};

}  // namespace insonate
