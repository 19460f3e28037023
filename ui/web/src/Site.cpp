#include "Site.h"

#include "attempt/AttemptPage.h"
#include "audit/AuditPage.h"
#include "classes/ClassPages.h"
#include "page/Page.h"
#include "person/PersonPage.h"
#include "signin/SignInPages.h"

#include <insonate/curriculum/BrowserSessions.h>
#include <insonate/curriculum/DatabaseFailures.h>
#include <insonate/embedded/web.h>
#include <insonate/teaching/HeatMap.h>

#include <sodium.h>

namespace insonate::web {
namespace {

Response showHome(const Visit& visit, const Parts& /*parts*/) {
  return redirect(visit.by->person().role == Role::Trainee ? "/me" : "/classes");
}

struct Route {
  std::string_view method, path;  ///< "*" stands for one variable part
  bool isPublic;                  ///< true: nobody needs to be signed in
  Response (*answer)(const Visit&, const Parts&);
};

constexpr Route kRoutes[]{
    {"GET", "/", false, &showHome},
    {"GET", "/sign-in", true, &showSignIn},
    {"POST", "/sign-in", true, &signIn},
    {"POST", "/sign-out", false, &signOut},
    {"GET", "/password", false, &showPasswordForm},
    {"POST", "/password", false, &changePassword},
    {"GET", "/me", false, &showOwnTraining},
    {"GET", "/attempts/*", false, &showAttempt},
    {"GET", "/classes", false, &showClasses},
    {"GET", "/classes/*", false, &showClass},
    {"GET", "/classes/*/people/*", false, &showMember},
    {"GET", "/audit", false, &showAudit},
};

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
  const std::string expected = formCode(visit.secret), &given = valueOf(visit.request.form, "code");
  // In constant time, which does not tell how many characters are right.
  return expected.size() == given.size() && sodium_memcmp(expected.data(), given.data(), expected.size()) == 0;
}

std::string fileNamed(std::string_view name) {
  for (const auto& file : embedded::web::files())
    if (file.name == name) return std::string(file.text);
  return {};
}

const std::pair<std::string, std::string> kKeptForAnHour{"Cache-Control", "max-age=3600"};

Response styleSheet() {
  std::string style = fileNamed("style");
  for (int step = 0; step <= 10; ++step) {
    const HeatColor color = heatColorOf(step * 10);
    const auto rgb = [&](int i) { return std::to_string(color[std::size_t(i)]); };
    style += ".heat" + std::to_string(step) + "{background:rgb(" + rgb(0) + "," + rgb(1) + "," + rgb(2) +
             ");color:" + (needsBlackText(color) ? "#000" : "#fff") + "}\n";
  }
  return {.type = "text/css; charset=utf-8", .body = std::move(style), .headers = {kKeptForAnHour}};
}

void addProtection(Response& response, const WebOptions& options) {
  response.headers.emplace_back("Content-Security-Policy",
                                "default-src 'none'; style-src 'self'; img-src 'self'; form-action 'self'; "
                                "frame-ancestors 'none'; base-uri 'none'");
  response.headers.emplace_back("X-Content-Type-Options", "nosniff");
  response.headers.emplace_back("Referrer-Policy", "same-origin");
  response.headers.emplace_back("Cross-Origin-Opener-Policy", "same-origin");
  if (options.behindProxy || !options.certificate.empty())
    response.headers.emplace_back("Strict-Transport-Security", "max-age=31536000");
  for (const auto& [name, value] : response.headers)
    if (name == "Cache-Control") return;
  response.headers.emplace_back("Cache-Control", "no-store");
}

/// The sentences of the failures name the place of the database and have parts of statements: they go to the log alone.
constexpr const char* kDatabaseFailed =
    "The database cannot be used at present. Try again in a minute; if this continues, tell the administrator of this "
    "server.";

}  // namespace

Response Site::answer(const Request& request) const {
  Response response;
  const DatabaseFailures failures;
  try {
    response = answerPage(request);
    if (!failures.sentences().empty()) {
      response = refusal({.request = request, .store = store_, .options = options_}, 503, kDatabaseFailed);
      response.headers.emplace_back("Retry-After", "30");
    }
  } catch (const std::exception& error) {
    response = {.status = 500,
                .type = "text/plain; charset=utf-8",
                .body = std::string("The request failed: ") + error.what() + "\n"};
  }
  addProtection(response, options_);
  return response;
}

Response Site::answerPage(const Request& request) const {
  if (request.method == "GET" && request.path == "/style.css") return styleSheet();
  if (request.method == "GET" && request.path == "/icon.svg")
    return {.type = "image/svg+xml", .body = fileNamed("icon"), .headers = {kKeptForAnHour}};
  if (request.method == "GET" && request.path == "/health") {
    const bool answers = store_.hasPeople().has_value();
    return {.status = answers ? 200 : 503,
            .type = "text/plain; charset=utf-8",
            .body = answers ? "ok\n" : "The database does not answer.\n"};
  }
  Visit visit{.request = request, .store = store_, .options = options_};
  visit.secret = valueOf(request.cookies, sessionCookie(options_));
  if (!visit.secret.empty()) {
    auto by = BrowserSessions(store_).resume(visit.secret);
    if (!by) return refusal({.request = request, .store = store_, .options = options_}, 503, by.error().message);
    visit.by = std::move(*by);
    if (!visit.by) visit.secret.clear();
  }
  bool isKnown = false;
  for (const Route& route : kRoutes) {
    const auto parts = partsOf(route.path, request.path);
    if (!parts) continue;
    isKnown = true;
    if (route.method != request.method) continue;
    if (!route.isPublic && !visit.by)
      return request.method == "GET" ? redirect("/sign-in?next=" + encoded(targetOf(request)))
                                     : refusal(visit, 403, "The session has ended. Sign in again.");
    if (request.method == "POST" && (comesFromElsewhere(request) || (visit.by && !hasFormCode(visit))))
      return refusal(visit, 403, "The form does not come from this page. Open the page again and repeat.");
    if (visit.by && visit.by->mustChangePassword() && !route.isPublic && request.path != "/password" &&
        request.path != "/sign-out")
      return redirect("/password");
    return route.answer(visit, *parts);
  }
  if (isKnown) return refusal(visit, 405, "This address does not take such requests.");
  return refusal(visit, 404, "There is no page at this address.");
}

}  // namespace insonate::web
