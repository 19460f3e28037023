#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/FormAgreement.h>
#include <insonate/curriculum/SignedIn.h>

#include <string>
#include <utility>
#include <vector>

namespace insonate {

/// Forms that were filled in: facts, which are neither changed nor deleted. About oneself, or by an instructor about
/// who learns in their cohorts; seen by whom they are about, and as attempts are. What a rater said of somebody's
/// attempt is told to other raters once they have filled in the same form about it themselves, whatever their role.
class FormStore {
 public:
  explicit FormStore(SignedIn by) : by_(std::move(by)) {}

  /// Gives the id. The same form once more is no error; another one of the same kind by the same rater about the same
  /// attempt is refused.
  Result<std::string> add(const FilledForm& filled) const;
  /// In the order in which they came.
  Result<std::vector<KeptForm>> ofPerson(const std::string& person) const;
  Result<std::vector<KeptForm>> ofAttempt(const std::string& attempt) const;
  /// About all who learn in a cohort, of one kind of form; in the order in which they came.
  Result<std::vector<KeptForm>> ofCohort(const std::string& cohort, const std::string& form) const;
  /// Agreement of the raters over all attempts of a cohort: figures that disclose nobody's answers.
  Result<FormAgreement> agreement(const std::string& cohort, const Form& form) const;

 private:
  SignedIn by_;
};

}  // namespace insonate
