#pragma once

#include "page/Page.h"

namespace insonate::web {

/// Shows how far the raters of a class agree on one form. `parts`: the id of the class; the query names the form
/// ("form", Form::name).
Response showRaters(const Visit& visit, const Parts& parts);
/// Sends the agreement as CSV (agreementCsv()), with the same parts and query.
Response exportAgreement(const Visit& visit, const Parts& parts);

}  // namespace insonate::web
