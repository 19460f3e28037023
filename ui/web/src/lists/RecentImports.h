#pragma once

#include "http/Messages.h"

#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <string>

namespace insonate::web {

/// Answers of imports that this program has just made. A second click on "Import" makes the browser drop the answer of
/// the first request, which has the only copy of the first passwords; the second request then gets the same answer. The
/// answers are in memory only, for ten minutes, and never on a disk. May be used on any thread.
class RecentImports {
 public:
  /// Returns the answer that a request with this key got before, or else the answer of `import`. An answer is kept if
  /// its status is 200. `key`: must identify the session and the page from which the request comes. A request waits
  /// while another import runs.
  Response answer(const std::string& key, std::int64_t now_us, const std::function<Response()>& import);
  /// Drops the answers that are older than ten minutes.
  void dropOld(std::int64_t now_us);

 private:
  struct Kept {
    std::string key{};
    std::int64_t since_us = 0;
    Response answer{};
  };
  std::mutex import_;  ///< locked while an import runs
  std::mutex mutex_;   ///< protects kept_
  std::deque<Kept> kept_;
};

}  // namespace insonate::web
