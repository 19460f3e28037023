#include "AttemptListing.h"

#include <insonate/procedure/AttemptRecording.h>
#include <insonate/ui/Attempts.h>

#include <QDir>
#include <algorithm>

namespace insonate::review {

std::vector<ListedAttempt> attemptsIn(const QString& folder) {
  std::vector<ListedAttempt> attempts;
  const QDir place(folder);
  for (const QString& name : place.entryList(QDir::Files)) {
    const QString file = place.filePath(name);
    if (!ui::isAttemptFile(file)) continue;
    const auto recording = AttemptRecording::open(file.toStdString());
    if (recording) attempts.push_back({file, recording->header(), recording->status(), recording->end_us()});
  }
  // ISO 8601 in one time zone, so that alphabetical order is that of time.
  std::ranges::stable_sort(attempts, std::greater{}, [](const ListedAttempt& one) { return one.header.begun; });
  return attempts;
}

}  // namespace insonate::review
