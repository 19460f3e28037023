#pragma once

#include "page/Page.h"

#include <string>

namespace insonate::web {

/// Returns the section with the button that downloads all data of this person. For pages of this person and of
/// administrators.
Markup downloadSection(const Visit& visit, const std::string& person);

/// Sends all data of the user as a ZIP file.
Response downloadOwnData(const Visit& visit, const Parts& parts);
/// Sends all data of the person whose id is the only part.
Response downloadPersonData(const Visit& visit, const Parts& parts);

}  // namespace insonate::web
