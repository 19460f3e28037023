#pragma once

#include "http/Messages.h"
#include "live/LiveUpdates.h"
#include "monitoring/Metrics.h"

#include <insonate/curriculum/CurriculumStore.h>
#include <insonate/web/WebServer.h>

#include <string>

namespace insonate::web {

struct Route;
struct Visit;

/// Answers requests to a curriculum database: finds the page for an address and the user of the session, and refuses
/// requests that do not come from the server's own pages. Counts and logs each request. Keeps only the counts between
/// requests. May be used on any thread.
class Site {
 public:
  Site(CurriculumStore store, WebOptions options)
      : store_(std::move(store)), options_(std::move(options)), live_(store_, options_.log) {}

  Response answer(const Request& request) const;
  /// Counts and logs a request that the connection refused (HttpServer::Refused).
  void noteRefused(int status) const;
  /// Ends the streams of open pages, which must be done before the connections end.
  void endStreams() { live_.end(); }

 private:
  Response answerRoute(const Request& request, const Route* route) const;
  Response answerPage(const Visit& visit, const Route& route) const;
  Visit visitOf(const Request& request) const;
  void note(const std::string& method, const std::string& route, int status, double seconds) const;
  void noteFailure(const Route* route, const char* event, const std::string& sentence) const;

  CurriculumStore store_;
  WebOptions options_;
  mutable Metrics metrics_{};
  mutable LiveUpdates live_;
};

}  // namespace insonate::web
