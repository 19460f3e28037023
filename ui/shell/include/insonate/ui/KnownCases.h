#pragma once

#include <QString>
#include <QStringList>
#include <optional>

namespace insonate::ui {

/// Returns the names of the built-in necks (cases/Phantom.h), easiest first.
QStringList builtInCaseNames();

/// Searches the built-in and the recent cases for a case with this title, or a built-in case with this name. Returns
/// the folder of the case, or the name of the built-in case. Empty if there is no such case.
std::optional<QString> findCaseLocation(const QString& nameOrTitle);

/// Returns the location from which trainees open the case at `place` (a folder or the name of a built-in case): the
/// folder of its published version, if there is one; else `place` itself.
QString trainingLocation(const QString& place);

/// Returns the title of the built-in neck with this name; any other text is returned unchanged.
QString builtInTitle(const QString& nameOrTitle);

}  // namespace insonate::ui
