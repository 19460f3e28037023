#pragma once

#include "page/Page.h"

namespace insonate::web {

/// Shows the people whom the query's "search", "role", "class" and "state" select, and a form to add one; for
/// administrators.
Response showPeople(const Visit& visit, const Parts& parts);
/// Adds the person that the form states; shows the password if the form had none.
Response addPerson(const Visit& visit, const Parts& parts);

}  // namespace insonate::web
