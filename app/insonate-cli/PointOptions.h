#pragma once

#include <insonate/core/Result.h>
#include <insonate/ultrasound/AcousticScene.h>

#include <string>
#include <vector>

namespace insonate::cli {

/// Reads the positions of point reflectors for measuring the point spread function. The argument is a list of depths in
/// mm on the probe's axis, such as "5,10,20", or a file with one point per line, "lateral,elevation,depth" in mm. Fails
/// if a number is not finite or a depth is not in front of the probe's face. The returned points are in the probe's
/// frame.
Result<std::vector<PointTarget>> readPoints(const std::string& listOrFile);

}  // namespace insonate::cli
