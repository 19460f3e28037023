#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptFacts.h>

#include <QString>
#include <string>
#include <vector>

/// Attempts that the store has not taken yet, in files of a folder of the user's: they outlive the program and a store
/// that cannot be reached. A file says whose an attempt is, for which level it was begun, and which recording shows it.
/// How it ended is worked out from the recording, never read from the file, which anyone could edit. Any thread,
/// several at once.
namespace insonate::train {

/// Folder of unsent facts, inside that of the recordings.
QString unsentFolder();
/// File of the recording of such an attempt; empty: it has none, or its name leads out of the folder.
QString recordingOf(const QString& folder, const AttemptFacts& facts);

/// An attempt's end replaces its beginning. Of the end nothing is written but the name of the recording.
Result<void> keepUnsent(const QString& folder, const AttemptFacts& facts);
/// Unsent attempts of a person, in the order in which they began. One that ended and whose recording is missing was
/// abandoned without metrics, as one that broke off. A file that cannot be read or scored stays in place and is left
/// out.
std::vector<AttemptFacts> unsentOf(const QString& folder, const std::string& person);
/// Removes facts that the store now has; later facts about the same attempt stay.
void forgetUnsent(const QString& folder, const AttemptFacts& facts);

}  // namespace insonate::train
