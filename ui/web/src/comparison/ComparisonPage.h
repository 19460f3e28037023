#pragma once

#include "page/Page.h"

namespace insonate::web {

/// Compares a class with another class in one metric. `parts`: the id of the class; the query has the id of the other
/// class ("with") and the metric ("metric", MetricMeaning::id).
Response showComparison(const Visit& visit, const Parts& parts);
/// Shows a person's place in the class, in the metric that the query names. `parts`: the ids of class and person.
Response showPlaceInClass(const Visit& visit, const Parts& parts);

}  // namespace insonate::web
