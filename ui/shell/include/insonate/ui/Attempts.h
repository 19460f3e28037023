#pragma once

#include <QString>
#include <string>

namespace insonate {
struct KeptAttempt;
}

namespace insonate::ui {

/// Folder of the user's recorded attempts: `attempts` in the user's data folder. It may not exist yet.
QString attemptsFolder();

/// Folder of unsent forms about attempts.
inline QString formDraftsFolder() {
  return attemptsFolder() + QStringLiteral("/drafts");
}

/// Ending of a recording's name: "2026-11-20 Textbook neck.attempt".
inline const QString kAttemptSuffix = QStringLiteral(".attempt");

/// Finds a recording on this computer by the name that a store gives it: in attemptsFolder(), else in `attempts` beside
/// the store's file, whose address is `store`. Empty if neither folder has it, or if the name leads out of them.
QString recordingHere(const std::string& name, const QString& store);
/// Returns the recording that the store itself keeps of an attempt, else finds it by its name as above.
QString recordingHere(const KeptAttempt& attempt, const QString& store);

/// Folder in which this workstation keeps the recordings of attempts whose store is a server.
QString serverRecordingsFolder();

/// Tells whether a path is a recorded attempt, by its name (also that of an unfinished part) or by the file's first
/// bytes.
bool isAttemptFile(const QString& path);

}  // namespace insonate::ui
