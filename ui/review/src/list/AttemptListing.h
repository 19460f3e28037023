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

/// Returns the recordings in a folder, the latest first, including attempts that were cut short. Files that cannot be
/// read are left out. For any thread; takes some milliseconds per file.
std::vector<ListedAttempt> attemptsIn(const QString& folder);

}  // namespace insonate::review
