#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <vtkAlgorithm.h>

namespace insonate {

/// Updates a filter; messages that VTK would print become the error. Reports progress as `from` to `to` of the whole
/// work; when the listener cancels, asks the filter to stop.
Result<void> runFilter(vtkAlgorithm& filter, const Progress& progress, std::string_view doing, double from, double to);

}  // namespace insonate
