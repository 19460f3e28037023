#pragma once

#include "page/Page.h"

namespace insonate::web {

/// States what the erasure of a person deletes and what stays, and asks for the sign-in name; for administrators. The
/// person's id is the only part.
Response showErasure(const Visit& visit, const Parts& parts);
/// Erases the person if the form has the sign-in name.
Response erasePerson(const Visit& visit, const Parts& parts);

}  // namespace insonate::web
