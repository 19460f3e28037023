#pragma once

#include <insonate/curriculum/FilledForm.h>
#include <insonate/curriculum/Form.h>
#include <insonate/curriculum/RaterComparison.h>

#include <span>
#include <string>
#include <vector>

namespace insonate {

/// Two raters, by name, and how far they agree on the attempts that both judged.
struct RaterPair {
  std::string first{}, second{};
  int attempts = 0;
  RaterComparison comparison{};
};

/// Agreement of raters who judged attempts by one form. Cohen's kappa compares two raters; three or more are compared
/// in pairs.
struct FormAgreement {
  int judged = 0;                  ///< attempts that somebody judged
  int judgedTwice = 0;             ///< by two at least
  int otherVersions = 0;           ///< forms that are left out, since they are of another version of the form
  std::vector<RaterPair> pairs{};  ///< by their names
};

/// Agreement of the raters; `forms` in the order in which they came. The first form of a rater about an attempt counts:
/// a form is handed in once, and a second one, which older programs kept, was filled in with the others' answers known.
/// Leaves out a form that is about no attempt, written by the person it is about, or withheld.
FormAgreement agreementOf(const Form& form, std::span<const KeptForm> forms);

/// A line for each two raters and item, and before them one for all items ("total"); what there is not is left empty.
std::string agreementCsv(const Form& form, const FormAgreement& agreement);

}  // namespace insonate
