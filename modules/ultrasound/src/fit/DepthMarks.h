#pragma once

#include "FovModel.h"

#include <opencv2/core.hpp>

#include <optional>

namespace insonate::fit {

/// Searches for the marks of a depth scale beside the model of the field of view: short marks at equal distances on a
/// line along the model's axis, in an image that is light on dark. Results are in pixels of this image.
std::optional<DepthRuler> depthMarks(const cv::Mat_<uchar>& gray, const FovModel& model);

}  // namespace insonate::fit
