#pragma once

#include "page/Page.h"

namespace insonate::web {

/// Shows the published cases that workstations receive from this server, and the levels whose cases are missing. For
/// instructors and administrators, with the levels of the classes that they may see.
Response showCases(const Visit& visit, const Parts& parts);

}  // namespace insonate::web
