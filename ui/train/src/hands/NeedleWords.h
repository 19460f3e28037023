#pragma once

#include <insonate/haptics/NeedleState.h>

#include <QString>

namespace insonate::train {

/// What happened to the needle, a sentence.
QString sentenceOf(const NeedleEvent& event);

/// Where the needle is and what it feels, a few words: "in the vein, 21.4 mm deep, 0.6 N"; in a test, without in what.
QString wordsOf(const NeedleState& state, bool silent = false);

}  // namespace insonate::train
