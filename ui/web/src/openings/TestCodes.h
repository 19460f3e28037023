#pragma once

#include "page/Page.h"

#include <string>
#include <utility>

/// Codes of the tests that an instructor has opened. The database stores only their hashes. The browser therefore keeps
/// each code in a cookie that only the session in which the test was opened can read.
namespace insonate::web {

/// Returns the header by which the browser keeps the code of an opening. `opening`: TestOpening::id; `page`: address of
/// the page that shows the code.
std::pair<std::string, std::string> codeHeader(const Visit& visit, const std::string& page, const std::string& opening,
                                               const std::string& code);
/// Returns the code of an opening; "" if this session has not opened the test.
std::string codeOf(const Visit& visit, const std::string& opening);

}  // namespace insonate::web
