#pragma once

#include "../class/ClassReading.h"

#include <QString>
#include <cstdint>

namespace insonate::review {

/// Describes the open tests of a class: "● Open: 'Jugular test' until 20 Nov 2026 14:30, with a code (3 of 12 can
/// take it)". If no test is open, says that attempts at tests are practice. Returns "" if the curriculum has no tests.
QString openTestsWords(const ClassFacts& facts, std::int64_t now_us);
/// Describes how many trainees of the class could take a test now: "3 of 12 can take it".
QString readinessWords(const ClassFacts& facts, int ready);
/// Returns the sign and the word of a state: "● open".
QString signedWordOf(OpeningState state);

}  // namespace insonate::review
