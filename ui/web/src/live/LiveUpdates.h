#pragma once

#include "http/EventStream.h"

#include <insonate/curriculum/CurriculumStore.h>
#include <insonate/web/WebServer.h>

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace insonate::web {

/// Tells open pages that their data have changed: looks for changes in the database every few seconds while pages are
/// open, on a thread of its own, and sends each page concerned the event "changed". The page then asks for its content
/// again, with the permissions of its user. Works with several servers, and with programs that use the database
/// directly. For any thread.
class LiveUpdates {
 public:
  /// `log`: receives failures of the database; may be empty.
  LiveUpdates(const CurriculumStore& store, Log log);
  ~LiveUpdates();
  LiveUpdates(const LiveUpdates&) = delete;
  LiveUpdates& operator=(const LiveUpdates&) = delete;

  /// Returns the number of the last change (StoreChanges::number), to be read before the content of a page is.
  std::int64_t numberOfLastChange() const;
  /// Opens a stream for a page that shows these people (Person::id) as they were at the change `since`; events have the
  /// number of their change as id. Null if there are too many streams, in all or for this user. A stream ends after
  /// a few minutes, so that the browser asks again and its permission is checked again.
  std::shared_ptr<EventStream> open(const std::string& user, std::set<std::string> people, std::int64_t since);
  /// Ends all streams; further ones are refused.
  void end();

 private:
  struct Page {
    std::shared_ptr<EventStream> stream{};
    std::string user{};
    std::set<std::string> people{};
    std::chrono::steady_clock::time_point opened{}, sent{};
  };
  void run();
  void tell(const std::set<std::string>& changed, std::int64_t number);

  const CurriculumStore store_;
  const Log log_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::vector<Page> pages_;
  std::int64_t told_ = -1;               ///< number of the last change that pages were told of
  std::optional<std::int64_t> begin_{};  ///< number of the change after which the thread is to look again
  bool isEnding_ = false;
  std::thread thread_;
};

}  // namespace insonate::web
