#pragma once

#include "page/Page.h"

namespace insonate::web {

/// Shows the members of a class, its curriculum and its name, with the forms that the user may send about them. The
/// class's id is the only part, as in the other functions.
Response showMembers(const Visit& visit, const Parts& parts);
/// Adds the person whose sign-in name or e-mail address the form's "person" is; "as" says in which role.
Response addMember(const Visit& visit, const Parts& parts);
/// Makes the account of a trainee, who joins the class; shows the password if the form had none.
Response addTrainee(const Visit& visit, const Parts& parts);
/// Removes the form's "person" (Person::id) from the class.
Response removeMember(const Visit& visit, const Parts& parts);
/// Sets the curriculum by which the class is taught to the form's "curriculum", "VERSION NAME".
Response setClassCurriculum(const Visit& visit, const Parts& parts);
Response renameClass(const Visit& visit, const Parts& parts);
/// Archives the class, or restores it, as the form's "state" says.
Response archiveClass(const Visit& visit, const Parts& parts);

}  // namespace insonate::web
