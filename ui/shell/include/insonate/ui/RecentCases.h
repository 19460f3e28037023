#pragma once

#include <QString>
#include <vector>

namespace insonate::ui {

struct RecentCase {
  QString folder, title;
};

/// Returns at most ten recent cases from the user's settings, the latest first; cases that no longer exist are left
/// out.
std::vector<RecentCase> recentCases();
void rememberCase(const RecentCase& opened);
void forgetRecentCases();

}  // namespace insonate::ui
