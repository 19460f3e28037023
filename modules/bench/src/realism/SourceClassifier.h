#pragma once

#include <string>
#include <vector>

namespace insonate::bench {

/// Features of one image, for the classifier.
struct FeatureRow {
  std::string source;  ///< e.g. the machine or data set, or the simulated neck
  bool simulated = false;
  std::vector<double> values;  ///< the same features for each row; NaN is replaced by the mean
};

/// Rates how simulated each row looks to a linear classifier that was trained without the row's source: in turn one
/// source is left out, and the classifier is trained on all others. The classifier is Fisher's discriminant of
/// standardized features, with its covariance shrunk by half toward the diagonal. A greater rating means more
/// simulated. The unit is the spread of the training rows, so that ratings are comparable between sources. NaN if the
/// other sources are all real or all simulated.
std::vector<double> leaveOneSourceOut(const std::vector<FeatureRow>& rows);

}  // namespace insonate::bench
