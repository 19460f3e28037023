#pragma once

#include "ClassReading.h"

#include <insonate/curriculum/Attention.h>
#include <insonate/curriculum/Implausible.h>
#include <insonate/curriculum/Unlocking.h>
#include <insonate/teaching/MetricCatalog.h>
#include <insonate/ui/PlainToolTip.h>

#include <QString>
#include <cstdint>
#include <string>
#include <vector>

namespace insonate::review {

/// Returns title and unit of a metric: "Needle path, mm".
QString titleWithUnit(const MetricMeaning& meaning);
/// Returns a number with its noun: "1 person", "3 people".
QString countOf(int count, const QString& one, const QString& many);
/// Formats a date in the user's time zone: "20 Nov 2026".
QString dayOf(std::int64_t time_us);
/// Returns the state of a learner at the time when the class was read, if the instructor may need to act.
Attention attentionOf(const ClassFacts& facts, const Member& member);
/// Describes the state that attentionOf() returns, and implausible attempts: "stuck", "idle for 5 weeks, implausible
/// attempt"; "" if there is none.
QString attentionWords(const ClassFacts& facts, const Member& member);
/// Describes only the state that attentionOf() returns.
QString stateWords(const ClassFacts& facts, const Member& member);
/// Tells whether one of the member's last attempts is implausible (ClassFacts::implausible).
bool hasImplausible(const ClassFacts& facts, const Member& member);
/// Describes the implausible values of an attempt: "implausibly fast: time to vein 1.5 s, implausibly
/// short: completed in 4.0 s".
QString displayText(const AttemptFacts& attempt, const std::vector<Implausible>& flags);
/// Returns a level's title, or its name if the curriculum is unknown or lacks the level.
QString levelTitle(const Curriculum* curriculum, const std::string& level);
/// Returns the word of a level's state: "mastered".
QString nameOf(LevelState state);
using ui::plainToolTip;
/// Returns "Passed", "Failed because ...", "Abandoned" or "Voided: ...", by the level's rule if it is known.
QString outcomeOf(const AttemptFacts& attempt, const Curriculum* curriculum);

}  // namespace insonate::review
