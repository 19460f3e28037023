#pragma once

#include <insonate/curriculum/FilledForm.h>
#include <insonate/curriculum/Form.h>
#include <insonate/curriculum/RaterComparison.h>

#include <span>
#include <string>
#include <vector>

namespace insonate {

/// Two raters, by name, with their agreement on the attempts that both judged.
struct RaterPair {
  std::string first{}, second{};
  int attempts = 0;
  RaterComparison comparison{};
};

/// Agreement of raters who judged attempts by one form. Cohen's kappa compares two raters; three or more are compared
/// in pairs.
struct FormAgreement {
  int judged = 0;                  ///< attempts judged by at least one rater
  int judgedTwice = 0;             ///< attempts judged by at least two raters
  int otherVersions = 0;           ///< forms that are left out since they belong to another version of the form
  std::vector<RaterPair> pairs{};  ///< sorted by the raters' names
};

/// Agreement of the raters; `forms` in the order of arrival. Only the first form of a rater about an attempt counts: a
/// form is submitted once, and a second form, which older programs stored, was filled in when the others' answers were
/// known. Leaves out forms that are about no attempt, that the person concerned wrote, or that are withheld.
FormAgreement agreementOf(const Form& form, std::span<const KeptForm> forms);

/// CSV with a line for each pair of raters and item, preceded by a line for all items ("total"). Missing values are
/// empty.
std::string agreementCsv(const Form& form, const FormAgreement& agreement);

}  // namespace insonate
