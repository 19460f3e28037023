#pragma once

#include "http/Messages.h"

#include <insonate/curriculum/CurriculumStore.h>
#include <insonate/web/WebServer.h>

namespace insonate::web {

/// Answers requests to a curriculum database: finds the page for an address, the user of the session, and refuses what
/// does not come from the server's own pages. For any thread; keeps nothing between requests.
class Site {
 public:
  Site(CurriculumStore store, WebOptions options) : store_(std::move(store)), options_(std::move(options)) {}

  Response answer(const Request& request) const;

 private:
  Response answerPage(const Request& request) const;

  CurriculumStore store_;
  WebOptions options_;
};

}  // namespace insonate::web
