#pragma once

#include "VolumeFile.h"

#include <insonate/cases/LabelFile.h>

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace insonate {

/// Returns the header fields that make an NRRD a 3D Slicer segmentation: one segment for each label that occurs.
std::vector<std::pair<std::string, std::string>> slicerFields(const PatientCase& patient);

/// Tells whether the key/value pairs of an NRRD header define segments of 3D Slicer.
bool isSlicerSegmentation(const std::map<std::string, std::string>& metadata);

/// Reads a 3D Slicer segmentation on `geometry`, which must have the size that the file states, and flattens its layers
/// into one label map in this program's numbers, with a note on the mapping. If `choices` is given, reads only the
/// taken segments, and fills LabelReadResult::parts.
Result<LabelReadResult> readSlicerSegmentation(const std::filesystem::path& file, const VolumeHeader& header,
                                               const VolumeGeometry& geometry,
                                               const StructureChoices* choices = nullptr);

}  // namespace insonate
