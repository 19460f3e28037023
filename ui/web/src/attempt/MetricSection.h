#pragma once

#include "page/Markup.h"

#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/Curriculum.h>

namespace insonate::web {

/// Returns the section with the metrics of an attempt: value, published values of novices and experts, standard of the
/// level; and below the table, definition, source and evidence of each metric. `level` may be null.
Markup metricSection(const AttemptFacts& attempt, const Level* level);

}  // namespace insonate::web
