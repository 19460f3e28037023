#pragma once

#include "page/Page.h"

namespace insonate::web {

/// Shows the openings of a class's tests, and a form to open one; the class's id is the only part.
Response showOpenings(const Visit& visit, const Parts& parts);
/// Opens a test of the class now, for the time and with the code that the form states.
Response openTest(const Visit& visit, const Parts& parts);
/// Closes the opening that the form names.
Response closeTest(const Visit& visit, const Parts& parts);

}  // namespace insonate::web
