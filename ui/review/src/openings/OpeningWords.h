#pragma once

#include "../class/ClassReading.h"

#include <QString>
#include <cstdint>

namespace insonate::review {

/// Returns whether tests of the class are open, in words: "● Open: 'Jugular test' until 20 Nov 2026 14:30, with a
/// code", or that attempts at tests are practice; "" if the curriculum has no tests.
QString openTestsWords(const ClassFacts& facts, std::int64_t now_us);
/// Returns the sign and the word of a state: "● open".
QString signedWordOf(OpeningState state);

}  // namespace insonate::review
