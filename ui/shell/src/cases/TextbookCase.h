#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <QString>
#include <memory>

namespace insonate::ui {

/// Where this program keeps its built-in neck: in the user's cache, under a name that changes with the program.
QString textbookFolder();

/// The built-in neck, read from `folder` when it is there, else made, and kept there for the next time while it is in
/// use already. That it cannot be kept is no failure.
Result<std::shared_ptr<const PatientCase>> textbookCase(const QString& folder, const Progress& progress);

}  // namespace insonate::ui
