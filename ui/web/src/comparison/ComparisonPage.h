#pragma once

#include "page/Page.h"

#include <insonate/core/Result.h>
#include <insonate/curriculum/MetricMeaning.h>
#include <insonate/curriculum/Person.h>
#include <insonate/curriculum/SignedIn.h>

namespace insonate::web {

/// Compares a class with another class in one metric. `parts`: the id of the class; the query has the id of the other
/// class ("with") and the metric ("metric", MetricMeaning::id).
Response showComparison(const Visit& visit, const Parts& parts);

/// Returns the section that shows a person's place in the class, in one metric; a sentence if too few people have
/// values. `person`: Person::id.
Result<Markup> placeInClassSection(const SignedIn& by, const Cohort& cohort, const std::string& person,
                                   const MetricMeaning& metric);

}  // namespace insonate::web
