#pragma once

#include <QString>
#include <string>

namespace insonate {
struct KeptAttempt;
}

namespace insonate::ui {

/// Where the user's attempts are recorded: `attempts` beside what else the program keeps of the user's. May not exist
/// yet.
QString attemptsFolder();

/// Where forms about them lie that were not handed in yet.
inline QString formDraftsFolder() {
  return attemptsFolder() + QStringLiteral("/drafts");
}

/// What recordings are called by: "2026-11-20 Textbook neck.attempt".
inline const QString kAttemptSuffix = QStringLiteral(".attempt");

/// Where the recording that a store names lies on this computer: in attemptsFolder(), else in `attempts` beside the
/// store's file, whose address is `store`. Empty where it is in neither, and where the name leads out of them.
QString recordingHere(const std::string& name, const QString& store);
/// The recording that the store keeps of an attempt; else the same.
QString recordingHere(const KeptAttempt& attempt, const QString& store);

/// Folder in which this workstation keeps the recordings of attempts whose store is a server.
QString serverRecordingsFolder();

/// Whether a path is that of a recorded attempt: by its name, also that of the part of one that was cut short, or by
/// how the file begins.
bool isAttemptFile(const QString& path);

}  // namespace insonate::ui
