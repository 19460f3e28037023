#pragma once

#include <insonate/core/Result.h>
#include <insonate/ultrasound/AcousticScene.h>

#include <string>
#include <vector>

namespace insonate::cli {

/// Reads point targets for measuring the point spread: a list of depths in mm, such as "5,10,20", on the axis of the
/// probe; or a file with one point a line, "lateral,elevation,depth" in mm of the probe's frame. Fails on anything that
/// is not a finite number, and on a depth that is not in front of the face. Points are in the probe's frame.
Result<std::vector<PointTarget>> readPoints(const std::string& listOrFile);

}  // namespace insonate::cli
