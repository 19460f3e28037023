#pragma once

#include <insonate/core/Result.h>
#include <insonate/ultrasound/Instruments.h>
#include <insonate/wire/Wire.h>

#include <span>
#include <string>

namespace insonate::cli {

/// Writes the shape of a wire in a patient, the file that `render --wire` reads. `nodes_mm` are in patient LPS.
Result<void> writeRod(const Wire& wire, std::span<const Vec3> nodes_mm, const std::string& file);
/// Reads a file that writeRod() has written.
Result<FlexibleRod> readRod(const std::string& file);

}  // namespace insonate::cli
