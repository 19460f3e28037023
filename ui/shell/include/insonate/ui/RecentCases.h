#pragma once

#include <QString>
#include <vector>

namespace insonate::ui {

struct RecentCase {
  QString folder, title;
};

/// Returns up to ten recent cases from the user's settings, latest first, without cases that no longer exist.
std::vector<RecentCase> recentCases();
void rememberCase(const RecentCase& opened);
void forgetRecentCases();

}  // namespace insonate::ui
