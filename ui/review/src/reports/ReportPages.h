#pragma once

#include "../class/ClassDesk.h"
#include "../person/PersonReading.h"

#include <QPainter>

namespace insonate::review {

/// A page about a class: who needs help first, with levels and the heat map. Where not all fit it says how many are
/// left out. `desk` has facts().
void paintClassReport(QPainter& painter, const ClassDesk& desk);

/// A page about one person: where they are and why, how they learn, and what they did last. `heat` as in
/// placeInClass().
void paintPersonReport(QPainter& painter, const PersonFacts& facts, const HeatMap& heat);

}  // namespace insonate::review
