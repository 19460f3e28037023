#pragma once

#include "../files/VolumeFile.h"
#include "SeriesGroups.h"

#include <insonate/cases/Import.h>

#include <optional>
#include <variant>
#include <vector>

namespace insonate {

/// An NRRD, NIfTI or MetaImage file as a series; `stack` is set if the file's slices must be resampled to an orthogonal
/// grid.
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
  std::vector<SkippedFile> skippedFiles;
  std::vector<SkippedFile> unreadable;  ///< the entries of skippedFiles that could not be opened
};

/// Returns "FILE cannot be read (why), and so are 2 more"; the list must not be empty.
std::string unreadableText(const std::vector<SkippedFile>& unreadable);

/// Reads the headers of all files in a folder and its subfolders, or of one file. For a single DICOM slice it also
/// reads the other slices of its series in the same folder; a DICOM directory stands for its folder. Fails on a missing
/// or unreadable input.
Result<InputScan> scanInput(const std::filesystem::path& input, const Progress& progress);

}  // namespace insonate
