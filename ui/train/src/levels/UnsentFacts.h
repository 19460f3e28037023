#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptFacts.h>

#include <QString>
#include <string>
#include <vector>

/// Attempts that were not sent to the store yet, in files of one of the user's folders, so that they survive the end of
/// the program and an unreachable store. A file contains the person, the level and the name of the recording. An
/// attempt's outcome is computed from the recording and never read from the file, which anyone could edit. For any
/// thread; calls may run in parallel.
namespace insonate::train {

/// Folder of unsent facts, inside the folder of the recordings.
QString unsentFolder();
/// Returns the path of an unsent attempt's recording; empty if it has no recording, or if the name leads out of the
/// folder.
QString recordingOf(const QString& folder, const AttemptFacts& facts);

/// Writes facts. Facts about an attempt's end replace those about its beginning; about the end, only the name of the
/// recording is written.
Result<void> keepUnsent(const QString& folder, const AttemptFacts& facts);
/// Returns a person's unsent attempts in the order in which they began. An ended attempt whose recording is missing is
/// returned as abandoned and without metrics. A file that cannot be read or scored is left in place and not returned.
std::vector<AttemptFacts> unsentOf(const QString& folder, const std::string& person);
/// Deletes facts that the store now has; facts about a later state of the same attempt stay.
void forgetUnsent(const QString& folder, const AttemptFacts& facts);

}  // namespace insonate::train
