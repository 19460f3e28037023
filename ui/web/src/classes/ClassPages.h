#pragma once

#include "page/Page.h"

namespace insonate::web {

/// Shows the classes that the user may see.
Response showClasses(const Visit& visit, const Parts& parts);
/// Shows who needs attention, the members and the heat map of a class, whose id is the only part.
Response showClass(const Visit& visit, const Parts& parts);

}  // namespace insonate::web
