#pragma once

#include "page/Page.h"

namespace insonate::web {

/// States what the deletion of a class deletes and what stays, and asks for the name of the class; for administrators.
/// The class's id is the only part.
Response showClassDeletion(const Visit& visit, const Parts& parts);
/// Deletes the class if the form has its name.
Response deleteClass(const Visit& visit, const Parts& parts);

}  // namespace insonate::web
