#pragma once

#include "../model/Disclosure.h"

#include <insonate/curriculum/Curriculum.h>
#include <insonate/procedure/AttemptScore.h>
#include <insonate/ui/AttemptWords.h>

#include <QString>

namespace insonate::train {

/// The needle's place as far as it is disclosed: without anatomy, whether the needle is in the skin, and whether it
/// was.
NeedlePlace disclosed(NeedlePlace place, const Disclosure& disclosure);

/// "guided", "hints", "test".
QString wordOf(Assistance assistance);

/// Capitalizes the first letter, for the beginning of a sentence.
QString capital(const QString& words);

/// "2:07".
QString clockOf(double time_s);

/// The line over a result: "71 of 100: succeeded", "Abandoned".
QString headlineOf(const AttemptScore& score, AttemptStatus status);

}  // namespace insonate::train
