#pragma once

#include <insonate/curriculum/Form.h>
#include <insonate/curriculum/Statistics.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace insonate {

/// Answers of two raters about one attempt.
struct RatedTwice {
  FormAnswers first{}, second{};
};

/// Agreement of two raters on one item, computed from the item's own grades.
struct ItemAgreement {
  std::string item{};  ///< FormItem::name
  int pairs = 0;
  std::optional<double> agreement{};
  std::optional<double> kappa{};
  std::optional<Estimate> points{};  ///< ICC(2,1)
};

/// Agreement of two raters on a form. Missing values are treated as in Agreement.h.
struct RaterComparison {
  int pairs = 0;                      ///< number of items that both raters answered with points, over all attempts
  std::optional<double> agreement{};  ///< share of pairs with equal answers
  std::optional<double> kappa{};      ///< Cohen's kappa; with quadratic weights if there are more than two grades
  std::optional<Estimate> scores{};   ///< ICC(2,1) of FormScore::percent over the attempts
  /// FormItem::name of the items on which the raters differed, the most frequent first, as topics for discussion.
  std::vector<std::string> differing{};
  std::vector<ItemAgreement> items{};  ///< items that have points, in the form's order
};

/// Compares two raters. Grades are an item's options that have points, in the order of rising points. The overall
/// values leave out items with fewer grades than the form's other items, since the grades of such items have another
/// meaning.
RaterComparison compareRaters(const Form& form, std::span<const RatedTwice> attempts);

}  // namespace insonate
