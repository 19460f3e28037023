#pragma once

#include <insonate/curriculum/FilledForm.h>
#include <insonate/curriculum/Form.h>
#include <insonate/curriculum/RaterComparison.h>

#include <span>
#include <string>
#include <vector>

namespace insonate {

/// Two raters (names) and their agreement on the attempts that both judged.
struct RaterPair {
  std::string first{}, second{};
  int attempts = 0;
  RaterComparison comparison{};
};

/// Agreement of raters who judged attempts by one form. Cohen's kappa compares two raters; three or more are compared
/// in pairs.
struct FormAgreement {
  int judged = 0;       ///< number of attempts judged by at least one rater
  int judgedTwice = 0;  ///< number of attempts judged by at least two raters
  /// number of filled forms that were left out because they belong to another version of the form
  int otherVersions = 0;
  std::vector<RaterPair> pairs{};  ///< agreement of each pair of raters, sorted by their names
};

/// Computes the agreement of raters from filled forms, which must be in the order in which they were submitted. Only
/// the first form of a rater about an attempt counts: when a rater submitted a second one, which older program versions
/// allowed, the rater already knew the answers of other raters. Forms about no attempt, by the person concerned, or
/// with withheld answers are left out.
FormAgreement agreementOf(const Form& form, std::span<const StoredForm> forms);

/// Writes the agreement as CSV: for each pair of raters one line for all questions ("total"), then one for each
/// question. Missing values are empty.
std::string agreementCsv(const Form& form, const FormAgreement& agreement);

}  // namespace insonate
