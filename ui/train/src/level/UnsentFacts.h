#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptFacts.h>

#include <QString>
#include <string>
#include <vector>

/// Facts of attempts that the store has not taken yet, in files of a folder of the user's: they outlive the program and
/// a store that cannot be reached. Any thread, several at once.
namespace insonate::train {

/// Beside the recordings.
QString unsentFolder();

/// An attempt's end replaces its beginning.
Result<void> keepUnsent(const QString& folder, const AttemptFacts& facts);
/// Of one person, in the order in which they began. What cannot be read stays where it is and is left out.
std::vector<AttemptFacts> unsentOf(const QString& folder, const std::string& person);
/// The store has these: what was kept of the same attempt since stays.
void forgetUnsent(const QString& folder, const AttemptFacts& facts);

}  // namespace insonate::train
