#pragma once

#include "page/Page.h"

namespace insonate::web {

/// Shows the rule by which old data are deleted, and what it concerns now. The query may name another rule, which can
/// be examined and then saved; for administrators.
Response showRetention(const Visit& visit, const Parts& parts);
/// Saves the rule of the form.
Response setRetention(const Visit& visit, const Parts& parts);

}  // namespace insonate::web
