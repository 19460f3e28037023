#pragma once

#include "../class/ClassController.h"
#include "../person/PersonReading.h"

#include <QPainter>

namespace insonate::review {

/// Paints a page about a class: people who need help first, with levels and the heat map. If not all people fit, the
/// page states how many are left out. `desk` must have facts().
void paintClassReport(QPainter& painter, const ClassController& controller);

/// Paints a page about one person: present level with the reason, learning curves, and the last attempts. `heat` as in
/// placeInClass().
void paintPersonReport(QPainter& painter, const PersonFacts& facts, const HeatMap& heat);

}  // namespace insonate::review
