#pragma once

#include <insonate/curriculum/Person.h>

#include <QString>
#include <QStringList>

namespace insonate::ui {

/// Returns "trainee", "instructor" or "administrator".
QString nameOf(Role role);
/// Returns the words for all roles in the order of Role.
QStringList roleWords();
/// Returns the role for a word; Trainee for an unknown word.
Role roleOf(const QString& word);

}  // namespace insonate::ui
