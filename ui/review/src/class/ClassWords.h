#pragma once

#include "ClassReading.h"
#include "MetricBook.h"

#include <insonate/curriculum/Implausible.h>
#include <insonate/ui/PlainToolTip.h>

#include <QString>
#include <cstdint>
#include <string>
#include <vector>

namespace insonate::review {

/// "Needle path, mm"
QString titleWithUnit(const MetricMeaning& meaning);
/// "1 person", "3 people"
QString countOf(int count, const QString& one, const QString& many);
/// Number with the digits that a table needs.
QString numberOf(double value);
/// "20 Nov 2026" in the user's time zone.
QString dayOf(std::int64_t time_us);
/// "slipped", "stuck", or "" without concern.
QString concernWord(Concern concern);
/// Concern about a member; none while it is unknown.
Concern concernOf(const Member& member);
/// "skin to vein in 1.5 s, completed in 4.0 s"
QString wordsOf(const AttemptFacts& attempt, const std::vector<Implausible>& flags);
/// The level's title, or its name where the curriculum lacks it or is not known.
QString levelTitle(const Curriculum* curriculum, const std::string& level);
using ui::plainToolTip;
/// "Passed", "Failed because ...", "Abandoned", "Voided: ...", with the level's rule, if known.
QString outcomeOf(const AttemptFacts& attempt, const Curriculum* curriculum);

}  // namespace insonate::review
