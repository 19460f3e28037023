#include <insonate/cases/CaseVersions.h>
#include <insonate/cases/Phantom.h>
#include <insonate/ui/KnownCases.h>
#include <insonate/ui/RecentCases.h>
#include <insonate/ui/Text.h>

namespace insonate::ui {
QStringList builtInCaseNames() {
  QStringList names;
  for (const PhantomVariant& one : phantomVariants()) names << qt(one.name);
  return names;
}

std::optional<QString> findCaseLocation(const QString& nameOrTitle) {
  for (const PhantomVariant& one : phantomVariants())
    if (nameOrTitle == qt(one.name) || nameOrTitle == qt(one.title)) return qt(one.name);
  for (const RecentCase& one : recentCases())
    if (one.title == nameOrTitle) return one.folder;
  return std::nullopt;
}

QString trainingLocation(const QString& place) {
  return builtInCaseNames().contains(place) ? place
                                            : QString::fromStdString(caseForTraining(place.toStdString()).string());
}

QString builtInTitle(const QString& nameOrTitle) {
  for (const PhantomVariant& one : phantomVariants())
    if (nameOrTitle == qt(one.name)) return qt(one.title);
  return nameOrTitle;
}

}  // namespace insonate::ui
