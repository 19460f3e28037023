#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <QString>
#include <memory>

namespace insonate::ui {

/// Folder of a built-in neck in the user's cache; its name depends on the program's version.
QString builtInFolder(const QString& variant);

/// Reads a built-in neck (cases/Phantom.h) from `folder` or, if it is not there, generates it. A generated neck is
/// returned at once and written to `folder` in the background; a failure to write it is ignored.
Result<std::shared_ptr<const PatientCase>> builtInCase(const QString& variant, const QString& folder,
                                                       const Progress& progress);

}  // namespace insonate::ui
