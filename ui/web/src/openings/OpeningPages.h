#pragma once

#include "page/Page.h"

namespace insonate::web {

/// Shows the openings of a class's tests, and a form for opening a test. `parts`: the id of the class.
Response showOpenings(const Visit& visit, const Parts& parts);
/// Opens a test for the class or, by an administrator, for everyone. The form states start, end and code. If the test
/// is open already at that time, the page warns, and opens the test when the form is sent again.
Response openTest(const Visit& visit, const Parts& parts);
/// Closes the opening that the form names.
Response closeTest(const Visit& visit, const Parts& parts);

}  // namespace insonate::web
