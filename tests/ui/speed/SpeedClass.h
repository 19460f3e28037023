#pragma once

#include <insonate/curriculum/CurriculumStore.h>

#include <QString>

namespace insonate::test {

inline constexpr int kSpeedTrainees = 200, kSpeedAttemptsEach = 500;
inline constexpr const char* kSpeedPassword = "a long sentence";

/// Fills an empty store in a file with a made-up class: each of 200 people made 500 attempts, of which two instructors
/// judged the newest. Throws where that fails.
void fillSpeedClass(const QString& file, const StoreServices& services);

/// Writes this many recordings into a folder, which is made.
void fillRecordings(const QString& folder, int count);

}  // namespace insonate::test
