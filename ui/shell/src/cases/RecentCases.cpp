#include <insonate/ui/RecentCases.h>

#include <QFileInfo>
#include <QSettings>

namespace insonate::ui {
namespace {

constexpr std::size_t kMost = 10;
const QString kList = QStringLiteral("recentCases");

}  // namespace

std::vector<RecentCase> recentCases() {
  std::vector<RecentCase> cases;
  QSettings settings;
  const int count = settings.beginReadArray(kList);
  for (int i = 0; i < count; ++i) {
    settings.setArrayIndex(i);
    RecentCase one{settings.value(QStringLiteral("folder")).toString(),
                   settings.value(QStringLiteral("title")).toString()};
    if (QFileInfo(one.folder).isDir()) cases.push_back(std::move(one));
  }
  settings.endArray();
  return cases;
}

void rememberCase(const RecentCase& opened) {
  std::vector<RecentCase> cases = recentCases();
  std::erase_if(cases, [&](const RecentCase& known) { return known.folder == opened.folder; });
  cases.insert(cases.begin(), opened);
  if (cases.size() > kMost) cases.resize(kMost);
  QSettings settings;
  settings.beginWriteArray(kList, int(cases.size()));
  for (std::size_t i = 0; i < cases.size(); ++i) {
    settings.setArrayIndex(int(i));
    settings.setValue(QStringLiteral("folder"), cases[i].folder);
    settings.setValue(QStringLiteral("title"), cases[i].title);
  }
  settings.endArray();
}

void forgetRecentCases() {
  QSettings().remove(kList);
}

}  // namespace insonate::ui
