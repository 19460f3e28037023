#pragma once

#include <insonate/core/Result.h>

#include <atomic>
#include <functional>
#include <map>
#include <string>

namespace insonate::bench {

struct Answer {
  int status = 0;
  std::string body{};
  double time_ms = 0;  ///< from the request to the last byte of the answer
};

/// Makes requests as a browser does: with cookies, over connections that stay open. The server counts connections by
/// the address of the client; each browser therefore has a loopback address of its own. For one thread.
class Browser {
 public:
  /// `url`: address of the server, "http://127.0.0.1:8443". `number`: 0 to 60 000, determines the client's address.
  Browser(std::string url, int number);
  ~Browser();
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  /// Signs a person in. Fails with a sentence if the server refuses or cannot be reached.
  Result<void> signIn(const std::string& name, const std::string& password);
  /// Requests a page. Fails if the server cannot be reached or breaks the connection.
  Result<Answer> get(const std::string& path);
  /// Does what get() does, as the script of a page that has learned of a change.
  Result<Answer> refresh(const std::string& path);
  /// Sends a form. Fails as get() does.
  Result<Answer> post(const std::string& path, const std::map<std::string, std::string>& form);
  /// Follows a stream of server-sent events on a second connection until the server ends it, or until `isOver`. Calls
  /// `changed` up to 3 s after an event "changed", at most every 5 s, as the script of the pages does; `changed` may
  /// request pages. Returns the status of the answer; 0: the connection broke.
  int follow(const std::string& path, const std::function<void()>& changed, const std::atomic<bool>& isOver);

 private:
  Result<Answer> perform(const std::string& path);

  const std::string url_, client_;
  void *curl_, *stream_;  ///< CURL handles: pages, and events
};

}  // namespace insonate::bench
