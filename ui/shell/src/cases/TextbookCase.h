#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <QString>

namespace insonate::ui {

/// Where this program keeps its built-in neck: in the user's cache, under a name that changes with the program.
QString textbookFolder();

/// The built-in neck, read from `folder` when it is there, else made and kept there for the next time. That it cannot
/// be kept is no failure.
Result<PatientCase> textbookCase(const QString& folder, const Progress& progress);

}  // namespace insonate::ui
