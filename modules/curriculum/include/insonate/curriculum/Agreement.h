#pragma once

#include <insonate/curriculum/Statistics.h>

#include <optional>
#include <span>
#include <vector>

/// These functions measure the agreement of raters who judged the same attempts.
namespace insonate {

/// Returns the share of pairs with equal values, 0 to 1. No value for empty lists or lists of unequal length.
std::optional<double> agreement(std::span<const int> first, std::span<const int> second);

enum class KappaWeights { None, Linear, Quadratic };

/// Returns Cohen's kappa of two raters' grades, (po - pe) / (1 - pe) (Educ Psychol Meas 1960, 20:37; weighted: Psychol
/// Bull 1968, 70:213). Grades are 0 to grades - 1, in rising order; at most 1000 grades. No value for empty lists,
/// unequal lengths, a grade out of range, or if the agreement expected by chance is 1.
std::optional<double> cohenKappa(std::span<const int> first, std::span<const int> second, int grades,
                                 KappaWeights weights = KappaWeights::None);

/// Returns the intraclass correlation ICC(2,1) of Shrout and Fleiss (Psychol Bull 1979, 86:420): two-way random
/// effects, each subject rated by each rater, absolute agreement of a single rating. `ratings[subject][rater]`. No
/// value for fewer than two subjects or raters, rows of unequal length, values that are not finite, or if all values
/// are equal. The estimate has no confidence interval for fewer than kFewestForInterval subjects, if subjects do not
/// differ, if raters differ only by a constant, or if raters differ so much that the interval has no degrees of
/// freedom.
std::optional<Estimate> intraclassCorrelation(const std::vector<std::vector<double>>& ratings,
                                              double confidence = 0.95);

}  // namespace insonate
