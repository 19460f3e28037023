#pragma once

#include <insonate/simulator/Imager.h>

#include <span>
#include <string>
#include <vector>

namespace insonate {

/// Returns reasons why images at these poses would mislead, one sentence each: a focus deeper than the image, a face
/// more than 15 mm inside the body or more than 30 mm off the skin (of labeled cases), more than a quarter of the
/// field of view outside the volume. Poses with the same problem share a sentence.
std::vector<std::string> poseWarnings(const PatientCase& patient, const ImagingSetup& setup,
                                      std::span<const Transform> path);

}  // namespace insonate
