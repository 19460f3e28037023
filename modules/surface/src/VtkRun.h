#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <vtkAlgorithm.h>

namespace insonate {

/// Runs a VTK filter; error messages that VTK would print become the returned error. Reports progress from `from` to
/// `to`. If the Progress callback cancels, asks the filter to stop.
Result<void> runFilter(vtkAlgorithm& filter, const Progress& progress, std::string_view doing, double from, double to);

}  // namespace insonate
