#pragma once

#include <string>
#include <vector>

namespace insonate::bench {

/// One image as a classifier sees it.
struct FeatureRow {
  std::string source;  ///< e.g. the machine or data set, or the neck that was simulated
  bool simulated = false;
  std::vector<double> values;  ///< the same features for each row; NaN counts as the mean
};

/// Rates how simulated each row looks to a linear classifier (Fisher's discriminant of standardized features, its
/// covariance shrunk by half toward the diagonal) that never saw the row's source: one source at a time is left out,
/// and all others are learned from. Greater is more simulated; in units of the training rows' spread, so that folds
/// compare. NaN if the other sources are all real or all simulated.
std::vector<double> leaveOneSourceOut(const std::vector<FeatureRow>& rows);

}  // namespace insonate::bench
