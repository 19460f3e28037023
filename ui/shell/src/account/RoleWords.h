#pragma once

#include <insonate/curriculum/Person.h>

#include <QString>
#include <QStringList>

namespace insonate::ui {

/// "trainee", "instructor", "administrator".
QString wordOf(Role role);
/// Words in the order of Role.
QStringList roleWords();
/// Role of a word; a trainee's for any other.
Role roleOf(const QString& word);

}  // namespace insonate::ui
