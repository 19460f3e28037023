#pragma once

#include "page/Page.h"

namespace insonate::web {

/// Returns the address of the briefing for a level of the class's curriculum.
std::string briefingAddress(const std::string& cohort, const std::string& level);

/// Briefing before an attempt: steps, errors, and conditions of a level. Parts are the class's id and the level's name.
Response showBriefing(const Visit& visit, const Parts& parts);

}  // namespace insonate::web
