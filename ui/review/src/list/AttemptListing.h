#pragma once

#include <insonate/procedure/AttemptHeader.h>

#include <QString>
#include <cstdint>
#include <vector>

namespace insonate::review {

struct ListedAttempt {
  QString file;
  AttemptHeader header;
  AttemptStatus status = AttemptStatus::CutShort;
  std::int64_t end_us = 0;
};

/// The recordings in a folder, those of attempts that were cut short included, the latest first. Files that cannot be
/// read are left out. Any thread; some milliseconds each.
std::vector<ListedAttempt> attemptsIn(const QString& folder);

}  // namespace insonate::review
