#pragma once

#include "page/Page.h"

namespace insonate::web {

/// Shows a form for a class list (CSV), as a file or as pasted text; the class's id is the only part, as in the other
/// functions.
Response showListImport(const Visit& visit, const Parts& parts);
/// Shows what the import would do with each line. Changes nothing.
Response checkList(const Visit& visit, const Parts& parts);
/// Imports all people of a list that was checked, or none, and shows the first passwords, this once.
Response importList(const Visit& visit, const Parts& parts);

}  // namespace insonate::web
