#include <insonate/procedure/AttemptRecorder.h>
#include <insonate/procedure/AttemptRecording.h>
#include <insonate/ui/Attempts.h>

#include <QFileInfo>
#include <QStandardPaths>

namespace insonate::ui {

QString attemptsFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/attempts");
}

bool isAttemptFile(const QString& path) {
  static const QString part =
      QString::fromStdString(AttemptRecorder::partOf(kAttemptSuffix.toStdString()).filename().string());
  if (!QFileInfo(path).isFile()) return false;
  return path.endsWith(kAttemptSuffix) || path.endsWith(part) || beginsAsRecording(path.toStdString());
}

}  // namespace insonate::ui
