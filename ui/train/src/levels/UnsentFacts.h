#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptFacts.h>

#include <QString>
#include <string>
#include <vector>

/// Attempts that were not sent to the store yet. They are stored in files in one of the user's folders, so that they
/// are not lost when the program ends or the store cannot be reached. A file contains the person, the level and the
/// name of the recording. An attempt's outcome is computed from the recording and never read from the file, which
/// anyone could edit. The functions may be called on any thread, and at the same time.
namespace insonate::train {

/// Returns the folder of unsent facts, inside the folder of the recordings.
QString unsentFolder();
/// Returns the path of an unsent attempt's recording; empty if the attempt has no recording, or if the name refers to a
/// file outside the folder.
QString recordingOf(const QString& folder, const AttemptFacts& facts);

/// Writes facts about an attempt. Facts about the end of an attempt replace those about its beginning. Of the facts
/// about the end, only the name of the recording is written.
Result<void> storeUnsent(const QString& folder, const AttemptFacts& facts);
/// Returns a person's unsent attempts in the order in which they began. An ended attempt whose recording is missing is
/// returned as abandoned and without metrics. A file that cannot be read or scored is left in place and not returned.
std::vector<AttemptFacts> unsentOf(const QString& folder, const std::string& person);
/// Finds recordings of a person's attempts whose program was killed, in the folder of the recordings. Gives them their
/// final names, and stores each attempt as abandoned. A recording that names no person stays as it is: see
/// AttemptHeader::recordedFor.
void recoverInterrupted(const QString& folder, const std::string& person);
/// Deletes facts that the store now has; facts about a later state of the same attempt stay.
void forgetUnsent(const QString& folder, const AttemptFacts& facts);

}  // namespace insonate::train
