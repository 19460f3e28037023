#pragma once

#include "DicomSlice.h"

#include <gdcmDataSet.h>

#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

/// The slices of a data set: one, or one for each frame of a multi-frame object, with what its functional groups say.
std::vector<DicomSlice> framesOf(const std::filesystem::path& file, const gdcm::DataSet& data);

std::string upper(std::string text);

}  // namespace insonate
