#pragma once

#include <span>
#include <vector>

namespace insonate {

/// Area under the ROC curve: separation of two groups by a value. 0.5: none; 1 or 0: complete.
struct RocArea {
  double area = 0.5;
  double low = 0, high = 1;  ///< 95 % confidence interval of `area`
};

/// Computes the ROC area of two groups: the share of pairs in which the positive value is larger, ties counted half.
/// The interval is DeLong's (Biometrics 1988, 44:837) on the logit, which keeps it within 0 and 1. If the groups are
/// completely separated, it is the exact (Clopper-Pearson) interval of a proportion; with fewer than two values in a
/// group, it is 0 to 1. Values must be finite.
RocArea rocArea(std::span<const double> positive, std::span<const double> negative);

/// Returns the two-sided p-value for ROC area 0.5 (both groups have the same distribution), from DeLong's variance; 1
/// if there is no variance.
double rocP(std::span<const double> positive, std::span<const double> negative);

/// Ratings of the same images by one reader.
struct ReaderRatings {
  /// ratings of the positive and of the negative images, in the same order for each reader
  std::vector<double> positive, negative;
};

/// Computes the mean ROC area of several readers of the same images. The interval takes into account that readers and
/// images are samples: both are resampled with replacement, 4000 times (Gallas et al., Acad Radiol 2009, 16:1387 on the
/// variance of readers and cases). With one reader, only images are resampled. The same seed gives the same interval.
RocArea readersRocArea(std::span<const ReaderRatings> readers, unsigned seed = 1);

}  // namespace insonate
