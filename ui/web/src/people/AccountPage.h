#pragma once

#include "page/Page.h"

namespace insonate::web {

/// Shows the account of a person and the forms that the user may send about it; the person's id is the only part.
Response showAccount(const Visit& visit, const Parts& parts);
/// Changes names, e-mail address and role to those of the form.
Response changeAccount(const Visit& visit, const Parts& parts);
/// Sets the password of the form, or a random one that it shows.
Response setAccountPassword(const Visit& visit, const Parts& parts);
/// Disables or enables the account, as the form's "state" says.
Response setAccountState(const Visit& visit, const Parts& parts);
/// Adds the person to the form's "class", as instructor or trainee as "as" says; removes the person from it.
Response joinClass(const Visit& visit, const Parts& parts);
Response leaveClass(const Visit& visit, const Parts& parts);

}  // namespace insonate::web
