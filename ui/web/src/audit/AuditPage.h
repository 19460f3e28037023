#pragma once

#include "page/Page.h"

namespace insonate::web {

/// Shows a page of the audit log, newest entries first. "before" in the query: the number of the entry that precedes
/// the page.
Response showAudit(const Visit& visit, const Parts& parts);

}  // namespace insonate::web
