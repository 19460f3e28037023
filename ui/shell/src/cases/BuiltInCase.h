#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <QString>
#include <memory>

namespace insonate::ui {

/// Folder of a built-in neck: in the user's cache, under a name that changes with the program.
QString builtInFolder(const QString& variant);

/// A built-in neck (cases/Phantom.h), read from `folder` when it is there, else made, and kept there for the next time
/// while it is in use already. That it cannot be kept is no failure.
Result<std::shared_ptr<const PatientCase>> builtInCase(const QString& variant, const QString& folder,
                                                       const Progress& progress);

}  // namespace insonate::ui
