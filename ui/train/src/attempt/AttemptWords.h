#pragma once

#include "../model/Disclosure.h"

#include <insonate/curriculum/Curriculum.h>
#include <insonate/procedure/AttemptScore.h>
#include <insonate/ui/AttemptWords.h>

#include <QString>

namespace insonate::train {

/// Returns that part of the needle's place which is disclosed. If anatomy is not disclosed, the result says only
/// whether the needle is or was in the skin.
NeedlePlace disclosed(NeedlePlace place, const Disclosure& disclosure);

/// Returns "guided", "hints" or "test".
QString assistanceText(Assistance assistance);

/// Capitalizes the first letter, for the beginning of a sentence.
QString capital(const QString& words);

/// Formats a time: "2:07".
QString clockOf(double time_s);

/// Heading of a result: "71 of 100 points: the attempt succeeded", "Abandoned".
QString headlineOf(const AttemptScore& score, AttemptStatus status);

}  // namespace insonate::train
