#pragma once

#include <insonate/curriculum/Form.h>
#include <insonate/curriculum/Statistics.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace insonate {

/// One attempt as two raters saw it.
struct RatedTwice {
  FormAnswers first{}, second{};
};

/// Agreement of two raters on one item, by the item's own grades.
struct ItemAgreement {
  std::string item{};  ///< FormItem::name
  int pairs = 0;
  std::optional<double> agreement{};
  std::optional<double> kappa{};
  std::optional<Estimate> points{};  ///< ICC(2,1)
};

/// Agreement of two raters on a form. Missing values are treated as in Agreement.h.
struct RaterComparison {
  int pairs = 0;                      ///< answers to one item, both with points
  std::optional<double> agreement{};  ///< share of pairs that are alike
  std::optional<double> kappa{};      ///< Cohen's; with quadratic weights where there are more than two grades
  std::optional<Estimate> scores{};   ///< ICC(2,1) of FormScore::percent over the attempts
  /// FormItem::name of where they differed, the most frequent first: what to talk about.
  std::vector<std::string> differing{};
  std::vector<ItemAgreement> items{};  ///< that have points, in the form's order
};

/// Grades are an item's options that have points, by rising points; items with fewer of them than the form's others are
/// left out, as their grades mean something else.
RaterComparison compareRaters(const Form& form, std::span<const RatedTwice> attempts);

}  // namespace insonate
