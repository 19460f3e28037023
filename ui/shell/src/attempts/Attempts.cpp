#include <insonate/curriculum/AttemptStore.h>
#include <insonate/procedure/AttemptRecorder.h>
#include <insonate/procedure/AttemptRecording.h>
#include <insonate/ui/Attempts.h>

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace insonate::ui {

QString attemptsFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/attempts");
}

QString findRecordingFile(const std::string& recording, const QString& store) {
  const QString name = QString::fromStdString(recording);
  // A name from a store must not lead out of the folders.
  if (name.isEmpty() || QFileInfo(name).fileName() != name) return {};
  for (const QString& folder : {attemptsFolder(), QFileInfo(store).absolutePath() + QStringLiteral("/attempts")})
    if (const QString file = QDir(folder).filePath(name); QFileInfo(file).isFile()) return file;
  return {};
}

QString findRecordingFile(const StoredAttempt& attempt, const QString& store) {
  if (!attempt.recordingFile.empty()) return QString::fromStdString(attempt.recordingFile.string());
  return findRecordingFile(attempt.facts.recording, store);
}

QString serverRecordingsFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/server.recordings");
}

bool isAttemptFile(const QString& path) {
  static const QString part =
      QString::fromStdString(AttemptRecorder::partialFile(kAttemptSuffix.toStdString()).filename().string());
  if (!QFileInfo(path).isFile()) return false;
  return path.endsWith(kAttemptSuffix) || path.endsWith(part) || hasRecordingSignature(path.toStdString());
}

}  // namespace insonate::ui
