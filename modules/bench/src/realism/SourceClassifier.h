#pragma once

#include <string>
#include <vector>

namespace insonate::bench {

/// Features of one image, for the classifier of simulated against real images.
struct FeatureRow {
  std::string source;  ///< origin of the image: machine or data set, or simulated neck
  bool simulated = false;
  std::vector<double> values;  ///< values of the same features for each image; NaN is replaced by the mean
};

/// Rates each image by a linear classifier of simulated (greater rating) against real images, which was trained on the
/// images of all other sources. The classifier is Fisher's discriminant of standardized features, with its covariance
/// shrunk by half toward the diagonal. The unit of a rating is the standard deviation of the training images, so that
/// ratings are comparable between sources. NaN if the other sources are all real or all simulated.
std::vector<double> leaveOneSourceOut(const std::vector<FeatureRow>& rows);

}  // namespace insonate::bench
