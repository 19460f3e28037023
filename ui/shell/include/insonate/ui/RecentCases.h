#pragma once

#include <QString>
#include <vector>

namespace insonate::ui {

struct RecentCase {
  QString folder, title;
};

/// The latest first, at most ten, kept in the user's settings; those that are gone are left out.
std::vector<RecentCase> recentCases();
void rememberCase(const RecentCase& opened);
void forgetRecentCases();

}  // namespace insonate::ui
