#pragma once

#include <string>

namespace insonate::camera {

/// Returns a sentence for the error `code` (errno) of a video device: what is wrong and what to do.
std::string videoError(const std::string& path, int code);

}  // namespace insonate::camera
