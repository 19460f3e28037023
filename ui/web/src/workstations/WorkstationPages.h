#pragma once

#include "page/Page.h"

namespace insonate::web {

/// Shows the workstations of the site, and a form to add one; for administrators.
Response showWorkstations(const Visit& visit, const Parts& parts);
/// Adds a workstation and shows its token, which cannot be shown again.
Response addWorkstation(const Visit& visit, const Parts& parts);
/// Ends the access of the workstation that the form names.
Response revokeWorkstation(const Visit& visit, const Parts& parts);

}  // namespace insonate::web
