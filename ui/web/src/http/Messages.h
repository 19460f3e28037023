#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace insonate::web {

using Fields = std::map<std::string, std::string, std::less<>>;

/// Returns the value of a field, or "" if there is none.
const std::string& valueOf(const Fields& fields, std::string_view name);

class EventStream;

/// An HTTP request. Names of headers are in lower case. If a field occurs more than once, the first one counts.
struct Request {
  std::string method{};  ///< method: "GET", "POST", ...; HEAD arrives as GET
  std::string path{};    ///< decoded path without query: "/classes/5"
  Fields query{}, form{}, cookies{}, headers{};
  Fields files{};        ///< bytes of uploaded files, by the name of their field (multipart/form-data)
  std::string body{};    ///< body of the request, as it was sent
  std::string client{};  ///< IP address of the client, or of the proxy in front of this server
};

struct Response {
  int status = 200;
  std::string type = "text/html; charset=utf-8";
  std::string body{};
  std::vector<std::pair<std::string, std::string>> headers{};
  std::shared_ptr<EventStream>
      events{};  ///< if set, what the answer goes on with after its headers, in place of `body`
  /// File of which a part is sent instead of `body`; empty: `body` is sent.
  std::filesystem::path file{};
  std::uint64_t fileBegin = 0, fileSize = 0;
  /// Owner of `file` if the file is temporary; kept until the answer was sent or its client has left.
  std::shared_ptr<const void> fileOwner{};
};

/// Reads "a=1&b=x%20y" (application/x-www-form-urlencoded). Text that is no valid UTF-8 and control characters other
/// than line breaks are left out.
Fields fieldsOfForm(std::string_view text);
/// Reads the header Cookie: "a=1; b=2".
Fields fieldsOfCookies(std::string_view text);
/// Returns a text without what is no valid UTF-8 and without control characters other than line breaks and tabs.
std::string plainText(const std::string& bytes);
/// Decodes %XX; `plusIsSpace` also decodes + as in forms. An incomplete code stays as it is.
std::string decoded(std::string_view text, bool plusIsSpace);
/// Encodes a text as one part of a path or as a value of a query.
std::string encoded(std::string_view text);
/// Compares secrets in constant time, which does not tell how many characters are right.
bool areEqual(const std::string& expected, const std::string& given);

}  // namespace insonate::web
