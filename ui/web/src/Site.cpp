#include "Site.h"

#include "attempt/AttemptPage.h"
#include "audit/AuditPage.h"
#include "cases/CasesPage.h"
#include "classes/ClassContents.h"
#include "classes/ClassPages.h"
#include "comparison/ComparisonPage.h"
#include "curricula/CurriculaPages.h"
#include "forms/FormPages.h"
#include "levels/BriefingPage.h"
#include "lists/ListImport.h"
#include "members/ClassDeletion.h"
#include "members/MembersPage.h"
#include "monitoring/MonitoringPages.h"
#include "openid/OpenIdPages.h"
#include "openid/OpenIdProvider.h"
#include "openings/OpeningPages.h"
#include "page/Page.h"
#include "people/AccountPage.h"
#include "people/DownloadSlots.h"
#include "people/PeoplePage.h"
#include "people/PersonDownload.h"
#include "people/PersonErasure.h"
#include "person/PersonPage.h"
#include "raters/RatersPage.h"
#include "retention/RetentionPages.h"
#include "signin/SignInPages.h"
#include "site/SiteApi.h"
#include "video/VideoPage.h"
#include "workstations/WorkstationPages.h"

#include <insonate/curriculum/BrowserSessions.h>
#include <insonate/curriculum/DatabaseFailures.h>
#include <insonate/embedded/web.h>
#include <insonate/site/PublishedCases.h>
#include <insonate/teaching/HeatMap.h>
#include <insonate/tissue/Labels.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace insonate::web {

/// Permission that an address requires.
enum class Access {
  File,         ///< everybody, without the database
  Monitoring,   ///< programs on this computer, and those that have the token
  Workstation,  ///< workstations, which send a token of their own
  Everybody,
  SignedIn
};

struct Route {
  std::string_view method, path;  ///< "*" stands for one variable part
  Access access;
  Response (*answer)(const Visit&, const Parts&);
};

namespace {

Response showHome(const Visit& visit, const Parts& /*parts*/) {
  return redirect(visit.by->person().role == Role::Trainee ? "/me" : "/classes");
}

/// The variable parts of a path, if it fits the pattern.
std::optional<Parts> partsOf(std::string_view pattern, std::string_view path) {
  Parts parts;
  while (!pattern.empty() && !path.empty()) {
    const auto next = [](std::string_view& text) {
      const std::string_view part = text.substr(0, text.find('/', 1));
      text.remove_prefix(part.size());
      return part;
    };
    const std::string_view expected = next(pattern), part = next(path);
    if (expected == "/*" && part.size() > 1)
      parts.emplace_back(part.substr(1));
    else if (expected != part)
      return std::nullopt;
  }
  return pattern.empty() && path.empty() ? std::optional(parts) : std::nullopt;
}

/// Path and query of a request, as they stand in an address.
std::string targetOf(const Request& request) {
  std::string target;
  std::string_view path = request.path;
  while (!path.empty()) {
    const std::string_view part = path.substr(0, path.find('/', 1));
    target += "/" + encoded(part.substr(1));
    path.remove_prefix(part.size());
  }
  for (const auto& [name, value] : request.query)
    target += (target.find('?') == std::string::npos ? "?" : "&") + encoded(name) + "=" + encoded(value);
  return target;
}

/// A page of another site can make a browser send a form here. Browsers then say where it came from.
bool comesFromElsewhere(const Request& request) {
  const std::string& site = valueOf(request.headers, "sec-fetch-site");
  if (!site.empty()) return site != "same-origin" && site != "none";
  const std::string& origin = valueOf(request.headers, "origin");
  if (origin.empty()) return false;
  const std::size_t host = origin.find("://");
  return host == std::string::npos || origin.substr(host + 3) != valueOf(request.headers, "host");
}

bool hasFormCode(const Visit& visit) {
  return areEqual(formCode(visit.secret), valueOf(visit.request.form, "code"));
}

std::string fileNamed(std::string_view name) {
  for (const auto& file : embedded::web::files())
    if (file.name == name) return std::string(file.text);
  return {};
}

const std::pair<std::string, std::string> kKeptForAnHour{"Cache-Control", "max-age=3600"};

Response showIcon(const Visit& /*visit*/, const Parts& /*parts*/) {
  return {.type = "image/svg+xml", .body = fileNamed("icon"), .headers = {kKeptForAnHour}};
}

Response scriptNamed(std::string_view name) {
  return {.type = "text/javascript; charset=utf-8", .body = fileNamed(name), .headers = {kKeptForAnHour}};
}

Response showLiveScript(const Visit& /*visit*/, const Parts& /*parts*/) {
  return scriptNamed("live");
}

Response showVideoScript(const Visit& /*visit*/, const Parts& /*parts*/) {
  return scriptNamed("video");
}

Response showStyleSheet(const Visit& /*visit*/, const Parts& /*parts*/) {
  std::string style = fileNamed("style");
  for (int step = 0; step <= 10; ++step) {
    const HeatColor color = heatColorOf(step * 10);
    const auto rgb = [&](int i) { return std::to_string(color[std::size_t(i)]); };
    style += ".heat" + std::to_string(step) + "{background:rgb(" + rgb(0) + "," + rgb(1) + "," + rgb(2) +
             ");color:" + (needsBlackText(color) ? "#000" : "#fff") + "}\n";
  }
  for (const auto& [kind, label] :
       {std::pair{"skin", kSkin}, {"bone", kBone}, {"airway", kAirway}, {"artery", kArtery}, {"vein", kVein}}) {
    const auto& color = labelTable()[label].color;
    style += std::string(".structure.") + kind + "{fill:rgb(" + std::to_string(color[0]) + "," +
             std::to_string(color[1]) + "," + std::to_string(color[2]) + ")}\n";
  }
  return {.type = "text/css; charset=utf-8", .body = std::move(style), .headers = {kKeptForAnHour}};
}

constexpr Route kRoutes[]{
    {"GET", "/style.css", Access::File, &showStyleSheet},
    {"GET", "/icon.svg", Access::File, &showIcon},
    {"GET", "/live.js", Access::File, &showLiveScript},
    {"GET", "/video.js", Access::File, &showVideoScript},
    {"GET", "/health", Access::Monitoring, &showHealth},
    {"GET", "/metrics", Access::Monitoring, &showMetrics},
    {"POST", "/api/site/cases", Access::Workstation, &listCases},
    {"POST", "/api/site/case-files/*/*/*", Access::Workstation, &sendCasePart},
    {"POST", "/api/site/*", Access::Workstation, &answerWorkstation},
    {"POST", "/api/site/recordings/*/*/*", Access::Workstation, &answerWorkstation},
    {"GET", "/sign-in", Access::Everybody, &showSignIn},
    {"POST", "/sign-in", Access::Everybody, &signIn},
    {"GET", "/sign-in/openid", Access::Everybody, &sendToProvider},
    {"GET", "/sign-in/openid/return", Access::Everybody, &returnFromProvider},
    {"GET", "/", Access::SignedIn, &showHome},
    {"POST", "/sign-out", Access::SignedIn, &signOut},
    {"GET", "/password", Access::SignedIn, &showPasswordForm},
    {"POST", "/password", Access::SignedIn, &changePassword},
    {"GET", "/me", Access::SignedIn, &showOwnTraining},
    {"POST", "/me/data", Access::SignedIn, &downloadOwnData},
    {"GET", "/me/events", Access::SignedIn, &followOwnTraining},
    {"GET", "/me/portfolio", Access::SignedIn, &showOwnPortfolio},
    {"GET", "/me/forms/*", Access::SignedIn, &showQuestionnaire},
    {"POST", "/me/forms/*", Access::SignedIn, &handInQuestionnaire},
    {"GET", "/attempts/*", Access::SignedIn, &showAttempt},
    {"GET", "/attempts/*/events", Access::SignedIn, &followAttempt},
    {"GET", "/attempts/*/video", Access::SignedIn, &showVideoProgress},
    {"POST", "/attempts/*/video", Access::SignedIn, &requestVideo},
    {"GET", "/attempts/*/video.webm", Access::SignedIn, &sendVideo},
    {"POST", "/attempts/*/accept", Access::SignedIn, &acceptAttempt},
    {"POST", "/attempts/*/void", Access::SignedIn, &voidAttempt},
    {"GET", "/attempts/*/forms/*", Access::SignedIn, &showAttemptForm},
    {"POST", "/attempts/*/forms/*", Access::SignedIn, &handInAttemptForm},
    {"POST", "/attempts/*/comments", Access::SignedIn, &addComment},
    {"POST", "/attempts/*/comments/*/remove", Access::SignedIn, &removeComment},
    {"GET", "/classes", Access::SignedIn, &showClasses},
    {"POST", "/classes", Access::SignedIn, &addClass},
    {"GET", "/classes/*", Access::SignedIn, &showClass},
    {"GET", "/classes/*/events", Access::SignedIn, &followClass},
    {"GET", "/classes/*/members", Access::SignedIn, &showMembers},
    {"POST", "/classes/*/members", Access::SignedIn, &addMember},
    {"POST", "/classes/*/members/new", Access::SignedIn, &addTrainee},
    {"POST", "/classes/*/members/remove", Access::SignedIn, &removeMember},
    {"GET", "/classes/*/import", Access::SignedIn, &showListImport},
    {"POST", "/classes/*/import", Access::SignedIn, &checkList},
    {"POST", "/classes/*/import/confirm", Access::SignedIn, &importList},
    {"POST", "/classes/*/curriculum", Access::SignedIn, &setClassCurriculum},
    {"POST", "/classes/*/name", Access::SignedIn, &renameClass},
    {"POST", "/classes/*/archive", Access::SignedIn, &archiveClass},
    {"GET", "/classes/*/delete", Access::SignedIn, &showClassDeletion},
    {"POST", "/classes/*/delete", Access::SignedIn, &deleteClass},
    {"GET", "/classes/*/comparison", Access::SignedIn, &showComparison},
    {"GET", "/classes/*/raters", Access::SignedIn, &showRaters},
    {"GET", "/classes/*/raters/agreement.csv", Access::SignedIn, &exportAgreement},
    {"GET", "/classes/*/levels/*", Access::SignedIn, &showBriefing},
    {"GET", "/classes/*/people/*", Access::SignedIn, &showMember},
    {"GET", "/classes/*/people/*/comparison", Access::SignedIn, &showPlaceInClass},
    {"GET", "/classes/*/people/*/portfolio", Access::SignedIn, &showPortfolio},
    {"GET", "/classes/*/people/*/events", Access::SignedIn, &followMember},
    {"GET", "/classes/*/export/attempts.csv", Access::SignedIn, &exportClassAttempts},
    {"GET", "/classes/*/export/grades.csv", Access::SignedIn, &exportClassGrades},
    {"GET", "/classes/*/export/statements.json", Access::SignedIn, &exportClassStatements},
    {"GET", "/classes/*/tests", Access::SignedIn, &showOpenings},
    {"POST", "/classes/*/tests", Access::SignedIn, &openTest},
    {"POST", "/classes/*/tests/close", Access::SignedIn, &closeTest},
    {"GET", "/people", Access::SignedIn, &showPeople},
    {"POST", "/people", Access::SignedIn, &addPerson},
    {"GET", "/people/*", Access::SignedIn, &showAccount},
    {"POST", "/people/*", Access::SignedIn, &changeAccount},
    {"POST", "/people/*/password", Access::SignedIn, &setAccountPassword},
    {"GET", "/people/*/erase", Access::SignedIn, &showErasure},
    {"POST", "/people/*/erase", Access::SignedIn, &erasePerson},
    {"POST", "/people/*/data", Access::SignedIn, &downloadPersonData},
    {"POST", "/people/*/state", Access::SignedIn, &setAccountState},
    {"POST", "/people/*/classes", Access::SignedIn, &joinClass},
    {"POST", "/people/*/classes/leave", Access::SignedIn, &leaveClass},
    {"GET", "/curricula", Access::SignedIn, &showCurricula},
    {"POST", "/curricula", Access::SignedIn, &publishCurriculum},
    {"GET", "/curricula/*/*", Access::SignedIn, &showCurriculum},
    {"GET", "/curricula/*/*/file", Access::SignedIn, &downloadCurriculum},
    {"GET", "/cases", Access::SignedIn, &showCases},
    {"GET", "/retention", Access::SignedIn, &showRetention},
    {"POST", "/retention", Access::SignedIn, &setRetention},
    {"GET", "/workstations", Access::SignedIn, &showWorkstations},
    {"POST", "/workstations", Access::SignedIn, &addWorkstation},
    {"POST", "/workstations/revoke", Access::SignedIn, &revokeWorkstation},
    {"GET", "/audit", Access::SignedIn, &showAudit},
};

bool hasHeader(const Response& response, std::string_view name) {
  return std::ranges::any_of(response.headers, [&](const auto& header) { return header.first == name; });
}

void addProtection(Response& response, const WebOptions& options) {
  // Pages with a video have a policy of their own.
  if (!hasHeader(response, "Content-Security-Policy"))
    response.headers.emplace_back("Content-Security-Policy",
                                  "default-src 'none'; style-src 'self'; img-src 'self'; script-src 'self'; "
                                  "connect-src 'self'; form-action 'self'; "
                                  "frame-ancestors 'none'; base-uri 'none'");
  response.headers.emplace_back("X-Content-Type-Options", "nosniff");
  response.headers.emplace_back("Referrer-Policy", "same-origin");
  response.headers.emplace_back("Cross-Origin-Opener-Policy", "same-origin");
  if (options.behindProxy || !options.certificate.empty())
    response.headers.emplace_back("Strict-Transport-Security", "max-age=31536000");
  if (!hasHeader(response, "Cache-Control")) response.headers.emplace_back("Cache-Control", "no-store");
}

/// The sentences of the failures name the place of the database and have parts of statements: they go to the log alone.
constexpr const char* kDatabaseFailed =
    "The database cannot be used at present. Try again in a minute; if this continues, tell the administrator of this "
    "server.";

constexpr const char* kSessionEnded =
    "Your session has ended, and your input was not stored. Go back to copy your input, then sign in again.";

/// HEAD arrives as GET; a method that the page does not take finds no route.
const Route* routeFor(const Request& request) {
  for (const Route& route : kRoutes)
    if (route.method == request.method && partsOf(route.path, request.path)) return &route;
  return nullptr;
}

/// Addresses have ids of people and are not logged.
std::string_view nameOf(const Route* route) {
  return route ? route->path : "other";
}

}  // namespace

Site::Site(CurriculumStore store, WebOptions options)
    : store_(std::move(store)),
      options_(std::move(options)),
      live_(store_, options_.log),
      downloads_(std::make_unique<DownloadSlots>()),
      cases_(std::make_unique<PublishedCases>(options_.cases)),
      classes_(std::make_unique<ClassContents>()) {
  if (!options_.openId.issuer.empty()) openId_ = std::make_unique<OpenIdProvider>(options_.openId);
}

Site::~Site() = default;

std::vector<std::pair<std::string_view, std::string_view>> Site::routes() {
  std::vector<std::pair<std::string_view, std::string_view>> all;
  for (const Route& route : kRoutes) all.emplace_back(route.method, route.path);
  return all;
}

Response Site::answer(const Request& request) const {
  const auto begun = std::chrono::steady_clock::now();
  const Route* route = routeFor(request);
  Response response;
  imports_.dropOld(store_.guest().now_us());
  const DatabaseFailures failures;
  try {
    response = answerRoute(request, route);
  } catch (const std::exception& error) {
    noteFailure(route, "exception", error.what());
    response = refusal(visitOf(request), 500, "The request failed. Tell the administrator of this server.");
  }
  for (const std::string& sentence : failures.sentences()) noteFailure(route, "database failure", sentence);
  metrics_.countDatabaseFailures(static_cast<std::int64_t>(failures.sentences().size()));
  if (!failures.sentences().empty() && (!route || route->access != Access::Monitoring)) {
    if (response.events) response.events->end();
    response = refusal(visitOf(request), 503, kDatabaseFailed);
    response.headers.emplace_back("Retry-After", "30");
  }
  addProtection(response, options_);
  const bool isUsual = request.method == "GET" || request.method == "POST";
  note(isUsual ? request.method : "other", std::string(nameOf(route)), response.status,
       std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count());
  return response;
}

std::optional<Response> Site::admit(const Request& request) const {
  const Route* route = routeFor(request);
  std::optional<Response> refused;
  try {
    refused = refusalOfSender(request, route);
  } catch (const std::exception& error) {
    noteFailure(route, "exception", error.what());
    refused = refusal(visitOf(request), 500, "The request failed. Tell the administrator of this server.");
  }
  if (!refused) return std::nullopt;
  addProtection(*refused, options_);
  note("POST", std::string(nameOf(route)), refused->status, 0);
  return refused;
}

std::optional<Response> Site::refusalOfSender(const Request& request, const Route* route) const {
  if (!route) return refusal(visitOf(request), 404, "There is no page at this address.");
  if (route->access == Access::Workstation) {
    auto sender = senderOf(request, store_);
    return sender ? std::nullopt : std::optional(std::move(sender.error()));
  }
  const auto by = BrowserSessions(store_).resume(valueOf(request.cookies, sessionCookie(options_)));
  if (!by) return refusal(visitOf(request), 503, kDatabaseFailed);
  return *by ? std::nullopt : std::optional(refusal(visitOf(request), 403, kSessionEnded));
}

Visit Site::visitOf(const Request& request) const {
  return {.request = request,
          .store = store_,
          .options = options_,
          .metrics = metrics_,
          .live = live_,
          .imports = imports_,
          .downloads = *downloads_,
          .cases = *cases_,
          .classes = *classes_,
          .openId = openId_.get()};
}

Response Site::answerRoute(const Request& request, const Route* route) const {
  Visit visit = visitOf(request);
  if (route && (route->access == Access::File || route->access == Access::Workstation)) return route->answer(visit, {});
  if (route && route->access == Access::Monitoring)
    return mayMonitor(request, options_)
               ? route->answer(visit, {})
               : refusal(
                     visit, 403,
                     "Only programs on this computer and programs with the token for monitoring may read this page.");
  visit.secret = valueOf(request.cookies, sessionCookie(options_));
  if (!visit.secret.empty()) {
    auto by = BrowserSessions(store_).resume(visit.secret, !isByItself(request));
    if (!by) return refusal(visitOf(request), 503, kDatabaseFailed);
    visit.by = std::move(*by);
    if (!visit.by) visit.secret.clear();
  }
  if (route) return answerPage(visit, *route);
  const bool isKnown =
      std::ranges::any_of(kRoutes, [&](const Route& one) { return partsOf(one.path, request.path).has_value(); });
  if (isKnown) return refusal(visit, 405, "This address does not accept requests of this kind.");
  return refusal(visit, 404, "There is no page at this address.");
}

Response Site::answerPage(const Visit& visit, const Route& route) const {
  const Request& request = visit.request;
  const bool isPublic = route.access == Access::Everybody;
  if (!isPublic && !visit.by)
    return request.method == "GET" ? redirect("/sign-in?next=" + encoded(targetOf(request)))
                                   : refusal(visit, 403, kSessionEnded);
  if (request.method == "POST" && (comesFromElsewhere(request) || (visit.by && !hasFormCode(visit))))
    return refusal(
        visit, 403,
        "The form was not sent from a current page of this server. Open the page again and repeat your input.");
  if (visit.by && visit.by->mustChangePassword() && !isPublic && request.path != "/password" &&
      request.path != "/sign-out")
    return redirect("/password");
  return route.answer(visit, *partsOf(route.path, request.path));
}

void Site::noteRefused(int status) const {
  note("other", "refused", status, 0);
}

void Site::note(const std::string& method, const std::string& route, int status, double seconds) const {
  metrics_.count(method, route, status, seconds);
  if (!options_.log) return;
  const nlohmann::ordered_json object{{"event", "request"},
                                      {"method", method},
                                      {"route", route},
                                      {"status", status},
                                      {"ms", std::round(seconds * 1e4) / 10}};
  options_.log(LogLevel::Info, object.dump());
}

void Site::noteFailure(const Route* route, const char* event, const std::string& sentence) const {
  if (!options_.log) return;
  const nlohmann::ordered_json object{{"event", event}, {"route", nameOf(route)}, {"message", sentence}};
  options_.log(LogLevel::Error, object.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

}  // namespace insonate::web
