#pragma once

#include <insonate/simulator/Imager.h>

#include <span>
#include <string>
#include <vector>

namespace insonate {

/// Returns warnings about the images at the poses of `path`, one sentence for each kind of problem: the focus is deeper
/// than the image; the probe's face is more than 15 mm inside the body or more than 30 mm off the skin (labeled cases
/// only); more than a quarter of the field of view is outside the volume.
std::vector<std::string> poseWarnings(const PatientCase& patient, const ImagingSetup& setup,
                                      std::span<const Transform> path);

}  // namespace insonate
