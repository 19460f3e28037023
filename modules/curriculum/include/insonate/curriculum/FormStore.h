#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/SignedIn.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace insonate {

/// A questionnaire, checklist or rating as it was filled in.
struct FilledForm {
  std::string id{};  ///< UUID; made when missing
  std::string form{};
  int formVersion = 0;
  std::string person{};   ///< whom it is about
  std::string attempt{};  ///< which of theirs; "": none in particular
  std::string by{};       ///< Person::id of who filled it in; the store's doing
  std::int64_t filled_us = 0;
  std::string answers{};  ///< JSON object, at most 1 MB, kept byte for byte

  bool operator==(const FilledForm&) const = default;
};

/// Forms that were filled in: facts, which are neither changed nor deleted. About oneself, or by an instructor about
/// who learns in their cohorts; seen by whom they are about, and as attempts are.
class FormStore {
 public:
  explicit FormStore(SignedIn by) : by_(std::move(by)) {}

  /// Gives the id. The same form once more is no error.
  Result<std::string> add(const FilledForm& filled) const;
  /// In the order in which they came.
  Result<std::vector<FilledForm>> ofPerson(const std::string& person) const;
  Result<std::vector<FilledForm>> ofAttempt(const std::string& attempt) const;
  /// About all who learn in a cohort, of one kind of form; in the order in which they came.
  Result<std::vector<FilledForm>> ofCohort(const std::string& cohort, const std::string& form) const;

 private:
  SignedIn by_;
};

}  // namespace insonate
