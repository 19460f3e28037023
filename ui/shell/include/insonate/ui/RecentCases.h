#pragma once

#include <QString>
#include <vector>

namespace insonate::ui {

struct RecentCase {
  QString folder, title;
};

/// Recent cases, the latest first, at most ten, kept in the user's settings; missing ones are left out.
std::vector<RecentCase> recentCases();
void rememberCase(const RecentCase& opened);
void forgetRecentCases();

}  // namespace insonate::ui
