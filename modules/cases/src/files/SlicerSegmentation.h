#pragma once

#include "VolumeFile.h"

#include <insonate/cases/LabelFile.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace insonate {

/// Returns the header fields that make an NRRD a 3D Slicer segmentation: one segment for each label that occurs.
std::vector<std::pair<std::string, std::string>> slicerFields(const PatientCase& patient);

/// Tells whether the header defines segments.
bool isSlicerSegmentation(const std::map<std::string, std::string>& metadata);

/// Flattens the layers of a segmentation into one map in this program's numbers, with a note on the mapping.
Result<LabelReadResult> fromSlicerSegmentation(const RawVolume& raw, const VolumeGeometry& geometry);

}  // namespace insonate
