#pragma once

#include "page/Page.h"

#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/Curriculum.h>

#include <optional>

namespace insonate::web {

/// Shows the user's own levels, learning curve and attempts in a class. "class" in the query: the id of the class.
Response showOwnTraining(const Visit& visit, const Parts& parts);
/// Shows levels, learning curve and attempts of a member of a class. `parts`: the ids of class and person.
Response showMember(const Visit& visit, const Parts& parts);
/// Show all levels, curves, checklists and attempts of the user or of a member, on one page for printing. Query and
/// parts are those of the two functions above.
Response showOwnPortfolio(const Visit& visit, const Parts& parts);
Response showPortfolio(const Visit& visit, const Parts& parts);
/// Send an event whenever the data of such a page have changed (livePage()).
Response followOwnTraining(const Visit& visit, const Parts& parts);
Response followMember(const Visit& visit, const Parts& parts);

/// Returns the curriculum of a class; empty if the class has none.
Result<std::optional<Curriculum>> curriculumOf(const SignedIn& by, const Cohort& cohort);

}  // namespace insonate::web
