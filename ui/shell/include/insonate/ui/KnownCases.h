#pragma once

#include <QString>
#include <QStringList>
#include <optional>

namespace insonate::ui {

/// The names of the built-in necks (cases/Phantom.h), easiest first.
QStringList builtInNames();

/// Where a case is that is known by its title, or as a built-in one by its name: its folder, or that name. Looked for
/// among the built-in and the recent ones; none: it is not known here.
std::optional<QString> placeOfCase(const QString& nameOrTitle);

/// Where a trainee gets the case of this place: its published version, else what is there.
QString placeForTraining(const QString& place);

/// The title of the built-in neck of this name; of others, what was given.
QString titleOfCase(const QString& nameOrTitle);

}  // namespace insonate::ui
