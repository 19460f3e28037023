#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <QString>
#include <memory>

namespace insonate::ui {

/// Returns the folder of a built-in neck in the user's cache. The folder's name depends on the program's version.
QString builtInFolder(const QString& variant);

/// Reads a built-in neck (cases/Phantom.h) from `folder`. If the folder does not contain the neck, generates it: the
/// generated neck is returned at once and written to `folder` in the background; a failure to write it is ignored.
Result<std::shared_ptr<const PatientCase>> builtInCase(const QString& variant, const QString& folder,
                                                       const Progress& progress);

}  // namespace insonate::ui
