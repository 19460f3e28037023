#pragma once

#include "http/Messages.h"
#include "lists/RecentImports.h"
#include "live/LiveUpdates.h"
#include "monitoring/Metrics.h"

#include <insonate/curriculum/CurriculumStore.h>
#include <insonate/web/WebServer.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace insonate {
class PublishedCases;
}

namespace insonate::web {

class ClassContents;
class DownloadSlots;
class OpenIdProvider;
struct Route;
struct Visit;

/// Answers requests to a curriculum database: finds the page for an address and the user of the session, and refuses
/// requests that do not come from the server's own pages. Counts and logs each request. Keeps only the counts, the keys
/// of the identity provider, the answers of recent imports, the downloads that go on and contents of class pages
/// between requests. May be used on any thread.
class Site {
 public:
  Site(CurriculumStore store, WebOptions options);
  ~Site();
  Site(const Site&) = delete;
  Site& operator=(const Site&) = delete;

  /// Returns method and path of each route, such as {"GET", "/attempts/*"}.
  static std::vector<std::pair<std::string_view, std::string_view>> routes();

  Response answer(const Request& request) const;
  /// Returns the refusal of a request whose body is large, if its sender is neither a workstation nor a signed-in user;
  /// counts and logs this refusal (HttpServer::Admit).
  std::optional<Response> admit(const Request& request) const;
  /// Counts and logs a request that the connection refused (HttpServer::Refused).
  void noteRefused(int status) const;
  /// Ends the streams of open pages, which must be done before the connections end.
  void endStreams() { live_.end(); }

 private:
  Response answerRoute(const Request& request, const Route* route) const;
  Response answerPage(const Visit& visit, const Route& route) const;
  std::optional<Response> refusalOfSender(const Request& request, const Route* route) const;
  Visit visitOf(const Request& request) const;
  void note(const std::string& method, const std::string& route, int status, double seconds) const;
  void noteFailure(const Route* route, const char* event, const std::string& sentence) const;

  CurriculumStore store_;
  WebOptions options_;
  mutable Metrics metrics_{};
  mutable LiveUpdates live_;
  mutable RecentImports imports_{};
  const std::unique_ptr<DownloadSlots> downloads_;
  const std::unique_ptr<PublishedCases> cases_;
  const std::unique_ptr<ClassContents> classes_;
  std::unique_ptr<OpenIdProvider> openId_{};  ///< null: users sign in with their password only
};

}  // namespace insonate::web
