#include "RoleWords.h"

#include <QCoreApplication>
#include <algorithm>

namespace insonate::ui {

QStringList roleWords() {
  const auto tr = [](const char* text) { return QCoreApplication::translate("RoleWords", text); };
  return {tr("trainee"), tr("instructor"), tr("administrator")};
}

QString nameOf(Role role) {
  return roleWords()[int(role)];
}

Role roleOf(const QString& word) {
  return Role(std::max(0, roleWords().indexOf(word)));
}

}  // namespace insonate::ui
