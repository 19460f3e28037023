#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <vtkAlgorithm.h>

namespace insonate {

/// Updates a filter. What VTK would print becomes the error. Reports `from` to `to` of the whole work and asks the
/// filter to stop when the listener does.
Result<void> runFilter(vtkAlgorithm& filter, const Progress& progress, std::string_view doing, double from, double to);

}  // namespace insonate
