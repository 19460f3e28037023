#pragma once

#include "page/Page.h"

namespace insonate::web {

/// Shows the openings of a class's tests, and a form for opening a test. `parts`: the id of the class.
Response showOpenings(const Visit& visit, const Parts& parts);
/// Opens a test of the class now. The form states the duration and the code.
Response openTest(const Visit& visit, const Parts& parts);
/// Closes the opening that the form names.
Response closeTest(const Visit& visit, const Parts& parts);

}  // namespace insonate::web
