#pragma once

#include "FovModel.h"

#include <opencv2/core.hpp>

#include <optional>

namespace insonate::fit {

/// Looks beside the model, in an image that is light on dark, for short marks at equal distances in a line along its
/// axis. Pixels of the image given.
std::optional<DepthRuler> depthMarks(const cv::Mat_<uchar>& grey, const FovModel& model);

}  // namespace insonate::fit
