#pragma once

#include <QString>
#include <string>

namespace insonate {
struct StoredAttempt;
}

namespace insonate::ui {

/// Returns the folder of the user's recorded attempts: `attempts` in the user's data folder. The folder need not exist
/// yet.
QString attemptsFolder();

/// Returns the folder of drafts: filled forms about attempts that the user has not sent to the store yet.
inline QString formDraftsFolder() {
  return attemptsFolder() + QStringLiteral("/drafts");
}

/// Ending of a recording's name: "2026-11-20 Textbook neck.attempt".
inline const QString kAttemptSuffix = QStringLiteral(".attempt");

/// Finds a recording on this computer by its file name in the store (AttemptFacts::recording). Searches
/// attemptsFolder(), then the folder `attempts` beside the file of the store, whose address is `store`. Returns the
/// path; empty if neither folder contains the file, or if the name refers to a file outside these folders.
QString findRecordingFile(const std::string& name, const QString& store);
/// Returns the path of the store's copy of an attempt's recording; without a copy, finds the recording by its file
/// name, as the function above does.
QString findRecordingFile(const StoredAttempt& attempt, const QString& store);

/// Returns the folder in which this workstation keeps the recordings of attempts if the store is on a server.
QString serverRecordingsFolder();

/// Tells whether a file is a recorded attempt, by the ending of its name (also that of an unfinished recording) or by
/// its first bytes.
bool isAttemptFile(const QString& path);

}  // namespace insonate::ui
