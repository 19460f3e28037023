#pragma once

#include <span>
#include <vector>

namespace insonate {

/// Area under the ROC curve, which measures how well a value separates two groups. 0.5: not at all; 1 or 0: completely.
struct RocArea {
  double area = 0.5;
  double low = 0, high = 1;  ///< 95 % confidence interval of `area`
};

/// Computes the ROC area of two groups: the share of pairs in which the value of the positive group is larger; ties
/// count half. The confidence interval is computed by the method of DeLong (Biometrics 1988, 44:837) for the logit, so
/// that the interval stays within 0 and 1. If the groups are completely separated, the interval is the exact
/// (Clopper-Pearson) interval of a proportion. With fewer than two values in a group, the interval is 0 to 1. Values
/// must be finite.
RocArea rocArea(std::span<const double> positive, std::span<const double> negative);

/// Returns the two-sided p-value of the hypothesis that the ROC area is 0.5, computed with DeLong's variance; 1 if the
/// variance is 0.
double rocP(std::span<const double> positive, std::span<const double> negative);

/// Ratings of the same images by one reader.
struct ReaderRatings {
  /// ratings of the positive and of the negative images, in the same order for each reader
  std::vector<double> positive, negative;
};

/// Computes the mean ROC area of several readers of the same images. The confidence interval accounts for the sampling
/// of both readers and images, which are resampled with replacement 4000 times (bootstrap; on the variance of readers
/// and cases see Gallas et al., Acad Radiol 2009, 16:1387). With one reader, only images are resampled. The same seed
/// gives the same interval.
RocArea readersRocArea(std::span<const ReaderRatings> readers, unsigned seed = 1);

}  // namespace insonate
