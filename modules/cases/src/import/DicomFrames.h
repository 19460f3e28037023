#pragma once

#include "DicomSlice.h"

#include <gdcmDataSet.h>

#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

/// Returns the slices of a data set: one, or one for each frame of a multi-frame object, with the values of its
/// functional groups.
std::vector<DicomSlice> framesOf(const std::filesystem::path& file, const gdcm::DataSet& data);

std::string upper(std::string text);

}  // namespace insonate
