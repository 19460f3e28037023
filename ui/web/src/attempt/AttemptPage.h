#pragma once

#include "page/Page.h"

namespace insonate::web {

/// Shows the result of an attempt, whose id is the only part, by the rules of the class named by the query's "class".
Response showAttempt(const Visit& visit, const Parts& parts);

}  // namespace insonate::web
