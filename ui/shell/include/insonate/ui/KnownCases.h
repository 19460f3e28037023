#pragma once

#include <QString>
#include <QStringList>
#include <optional>

namespace insonate::ui {

/// The names of the built-in necks (cases/Phantom.h), easiest first.
QStringList builtInNames();

/// Place of a case that is known by its title, or of a built-in one by its name: its folder, or that name. Searches
/// the built-in and the recent cases; empty if it is not known here.
std::optional<QString> placeOfCase(const QString& nameOrTitle);

/// Place from which a trainee gets this case: its published version, else the case itself.
QString placeForTraining(const QString& place);

/// The title of the built-in neck of this name; any other text is returned unchanged.
QString titleOfCase(const QString& nameOrTitle);

}  // namespace insonate::ui
