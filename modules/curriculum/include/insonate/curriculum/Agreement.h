#pragma once

#include <insonate/curriculum/Statistics.h>

#include <optional>
#include <span>
#include <vector>

/// Agreement of raters who judged the same attempts.
namespace insonate {

/// Share of pairs that are alike, 0 to 1. No value for empty lists or lists of unequal length.
std::optional<double> agreement(std::span<const int> first, std::span<const int> second);

enum class KappaWeights { None, Linear, Quadratic };

/// Cohen's kappa of two raters, (po - pe) / (1 - pe) (Educ Psychol Meas 1960, 20:37; weighted: Psychol Bull 1968,
/// 70:213). Grades are 0 to grades - 1, in order, 1000 at most. No value for empty lists, unequal lengths, a grade
/// outside, or if chance alone would always agree.
std::optional<double> cohenKappa(std::span<const int> first, std::span<const int> second, int grades,
                                 KappaWeights weights = KappaWeights::None);

/// ICC(2,1) of Shrout and Fleiss (Psychol Bull 1979, 86:420): each subject is rated by each rater, the raters stand for
/// others, absolute agreement of a single rating. `ratings[subject][rater]`. None for fewer than two subjects or
/// raters, rows of unequal length, values that are not finite or all alike. Without an interval
/// for fewer than kFewestForInterval subjects, where subjects do not differ, or raters differ by nothing but a
/// constant, or by so much that the interval's degrees of freedom vanish.
std::optional<Estimate> intraclassCorrelation(const std::vector<std::vector<double>>& ratings,
                                              double confidence = 0.95);

}  // namespace insonate
