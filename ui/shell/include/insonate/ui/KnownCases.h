#pragma once

#include <QString>
#include <QStringList>
#include <optional>

namespace insonate::ui {

/// The names of the built-in necks (cases/Phantom.h), easiest first.
QStringList builtInNames();

/// Finds a case by its title, or a built-in case by its name, among the built-in and the recent cases. Returns its
/// folder, or the built-in name; empty if this computer knows no such case.
std::optional<QString> placeOfCase(const QString& nameOrTitle);

/// Returns the place from which a trainee opens this case: its published version, else the case itself.
QString placeForTraining(const QString& place);

/// The title of the built-in neck of this name; any other text is returned unchanged.
QString titleOfCase(const QString& nameOrTitle);

}  // namespace insonate::ui
