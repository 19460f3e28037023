#pragma once

#include "../files/VolumeFile.h"
#include "SeriesGroups.h"

#include <insonate/cases/Import.h>

#include <optional>
#include <variant>
#include <vector>

namespace insonate {

/// A volume file as a series; `stack` is set where its slices must be resampled to an orthogonal grid.
struct VolumeSeries {
  std::filesystem::path file;
  std::optional<SliceStack> stack;
  StackPlan plan;
};

/// A listed series and the data needed to read it.
struct FoundSeries {
  SeriesInfo info;
  std::variant<DicomSeries, VolumeSeries> data;
};

struct InputScan {
  std::vector<FoundSeries> series;
  std::vector<SetAside> setAside;
  std::vector<SetAside> unreadable;  ///< of these, the files and folders that could not be opened
};

/// "FILE cannot be read (why), and so are 2 more"; the list is not empty.
std::string unreadableText(const std::vector<SetAside>& unreadable);

/// Reads the headers of a folder with its subfolders, or of one file; of a DICOM slice, those of its series beside it,
/// too; a DICOM directory stands for its folder. Fails on a missing or unreadable input.
Result<InputScan> scanInput(const std::filesystem::path& input, const Progress& progress);

}  // namespace insonate
