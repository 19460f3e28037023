#pragma once

#include "page/Page.h"

namespace insonate::web {

/// Shows a page of the audit log, newest entries first; the query's "before" is the number of the entry above the page.
Response showAudit(const Visit& visit, const Parts& parts);

}  // namespace insonate::web
