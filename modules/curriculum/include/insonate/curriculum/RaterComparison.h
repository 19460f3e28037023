#pragma once

#include <insonate/curriculum/Form.h>
#include <insonate/curriculum/Statistics.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace insonate {

/// Answers of two raters about one attempt.
struct RatingPair {
  FormAnswers first{}, second{};
};

/// Agreement of two raters on one question of a form, over the attempts that both rated. A member is empty in the cases
/// in which the functions of Agreement.h return no value.
struct ItemAgreement {
  std::string item{};  ///< question: FormItem::name
  int pairs = 0;
  std::optional<double> agreement{};
  std::optional<double> kappa{};
  std::optional<Estimate> points{};  ///< ICC(2,1) of the points; empty if the options have no points
};

/// Agreement of two raters on a form. A member is empty in the cases in which the functions of Agreement.h return no
/// value.
struct RaterComparison {
  int pairs = 0;                      ///< number of items that both raters answered with points, over all attempts
  std::optional<double> agreement{};  ///< share of `pairs` with equal answers
  std::optional<double> kappa{};      ///< Cohen's kappa; with quadratic weights if there are more than two grades
  std::optional<Estimate> scores{};   ///< ICC(2,1) of FormScore::percent over the attempts
  /// Questions on which the raters differed (FormItem::name), the most frequent first, as topics for discussion.
  std::vector<std::string> differing{};
  std::vector<ItemAgreement> items{};  ///< agreement on each question with options, in the form's order
};

/// Compares the answers of two raters. The grades of a question are its options that have points, in the order of
/// rising points. A question whose options have no points is compared by all its options, with unweighted kappa. For
/// `agreement` and `kappa` of the whole form, such questions, and questions with fewer grades than the other questions,
/// are left out, since their answers have another meaning.
RaterComparison compareRaters(const Form& form, std::span<const RatingPair> attempts);

}  // namespace insonate
