#include "openid/OpenIdPages.h"

#include "http/ClientAddress.h"
#include "openid/OpenIdProvider.h"
#include "openid/ProviderAddress.h"
#include "openid/SignInTry.h"
#include "signin/SignInPages.h"

#include <insonate/curriculum/BrowserSessions.h>

#include <nlohmann/json.hpp>

#include <chrono>
#include <optional>

namespace insonate::web {
namespace {

std::int64_t secondsNow() {
  using namespace std::chrono;
  return duration_cast<seconds>(system_clock::now().time_since_epoch()).count();
}

std::string tryCookie(const WebOptions& options) {
  return hasHttps(options) ? "__Host-insonate-openid" : "insonate-openid";
}

/// An empty value deletes the cookie. SameSite=Lax: the browser must send the cookie when the provider sends it back.
std::pair<std::string, std::string> tryHeader(const WebOptions& options, const std::string& value) {
  const std::int64_t age_s = value.empty() ? 0 : SignInTry::kLongest_s;
  return {"Set-Cookie", tryCookie(options) + "=" + value + "; Path=/; HttpOnly; SameSite=Lax; Max-Age=" +
                            std::to_string(age_s) + (hasHttps(options) ? "; Secure" : "")};
}

/// The provider accepts only addresses that its administrator has entered, so that a forged Host leads nowhere. Empty
/// if Host is no name of a server.
std::string returnAddress(const Visit& visit) {
  constexpr std::size_t kLongestHost = 255;
  const std::string& host = valueOf(visit.request.headers, "host");
  const bool isHost =
      !host.empty() && host.size() <= kLongestHost &&
      host.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.-:") == std::string::npos;
  if (!isHost) return {};
  return (hasHttps(visit.options) ? "https://" : "http://") + host + std::string(kOpenIdReturn);
}

Response failedSignIn(const Visit& visit, int status, const std::string& sentence) {
  return page(visit, "Sign in", troubleLine(sentence) + element("p", {}, link("/sign-in", "Go to the sign-in page")),
              status);
}

/// The log gets the reason, which has no data of the user; the page says what the user can do.
Response loggedFailure(const Visit& visit, LogLevel level, const std::string& reason, int status,
                       const std::string& sentence) {
  if (visit.options.log) {
    const nlohmann::ordered_json object{
        {"event", "openid failure"}, {"route", visit.request.path}, {"message", reason}};
    visit.options.log(level, object.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  }
  return failedSignIn(visit, status, sentence);
}

Response failedAtProvider(const Visit& visit, const std::string& reason) {
  return loggedFailure(visit, LogLevel::Error, reason, 502,
                       "Signing in with " + visit.options.openId.name +
                           " failed. Try again in a minute; if this continues, tell the administrator of this server.");
}

/// Checks that the request is the return of the sign-in that this browser began; otherwise returns the answer.
std::optional<Response> checkReturn(const Visit& visit, const std::optional<SignInTry>& tried) {
  const Fields& query = visit.request.query;
  const std::string& name = visit.options.openId.name;
  if (!tried || !areEqual(tried->state, valueOf(query, "state")))
    return loggedFailure(visit, LogLevel::Info, "The state of a return does not match its cookie.", 400,
                         "This sign-in has expired, or was begun in another browser. Begin the sign-in again.");
  if (!valueOf(query, "error").empty())
    return loggedFailure(visit, LogLevel::Info, "The provider refused a sign-in.", 403,
                         name + " did not sign you in. Try again, or ask the administrator of " + name + ".");
  // RFC 9207: the answer of another provider.
  if (query.contains("iss") && valueOf(query, "iss") != visit.options.openId.issuer)
    return loggedFailure(visit, LogLevel::Info, "A return names another provider.", 400,
                         "This answer is not from " + name + ". Begin the sign-in again.");
  if (valueOf(query, "code").empty())
    return loggedFailure(visit, LogLevel::Info, "A return has no code.", 400,
                         "The answer of " + name + " is incomplete. Begin the sign-in again.");
  return std::nullopt;
}

Response sessionFor(const Visit& visit, const VerifiedEmail& email, const std::string& address,
                    const std::string& next) {
  const BrowserSessions sessions(visit.store);
  const auto secret = sessions.begin(email, address);
  if (!secret)
    return loggedFailure(visit, LogLevel::Info, "No account may be used for a sign-in.", 403, secret.error().message);
  // A session that the browser had before ends, so that nobody continues it.
  if (!visit.secret.empty()) (void)sessions.end(visit.secret);
  Response response = redirect(localAddress(next));
  response.headers.push_back(sessionHeader(visit.options, *secret));
  return response;
}

Response answerReturn(const Visit& visit) {
  const auto tried = readTry(valueOf(visit.request.cookies, tryCookie(visit.options)), secondsNow());
  if (auto refused = checkReturn(visit, tried)) return *std::move(refused);
  // Returns without the state of this browser do not count, else pages of other sites could lock the address.
  const std::string address = networkOf(clientAddress(visit.request, visit.options));
  if (const auto allowed = BrowserSessions(visit.store).countSignInAttempt(address); !allowed)
    return failedSignIn(visit, 429, allowed.error().message);
  const auto email =
      visit.openId->redeem(valueOf(visit.request.query, "code"), *tried, returnAddress(visit), secondsNow());
  if (!email) return failedAtProvider(visit, email.error().message);
  if (!*email)
    return loggedFailure(
        visit, LogLevel::Info, "The ID token has no e-mail address that the provider has verified.", 403,
        visit.options.openId.name + " did not send a verified e-mail address. Ask the administrator of " +
            visit.options.openId.name + " to verify your e-mail address and to send it.");
  return sessionFor(visit, **email, address, tried->next);
}

Response notConfigured(const Visit& visit) {
  return refusal(visit, 404, "There is no page at this address.");
}

}  // namespace

Response sendToProvider(const Visit& visit, const Parts& /*parts*/) {
  if (!visit.openId) return notConfigured(visit);
  const std::string back = returnAddress(visit);
  if (back.empty()) return refusal(visit, 400, "The request does not name this server. Open the sign-in page again.");
  const auto tried = beginTry(localAddress(valueOf(visit.request.query, "next")), secondsNow());
  if (!tried) return failedAtProvider(visit, tried.error().message);
  const auto address = visit.openId->signInAddress(*tried, back);
  if (!address) return failedAtProvider(visit, address.error().message);
  Response response = redirect(*address);
  response.headers.push_back(tryHeader(visit.options, cookieValueOf(*tried)));
  return response;
}

Response returnFromProvider(const Visit& visit, const Parts& /*parts*/) {
  if (!visit.openId) return notConfigured(visit);
  Response response = answerReturn(visit);
  // The cookie is for one return only, also if the return failed.
  response.headers.push_back(tryHeader(visit.options, ""));
  return response;
}

Markup providerLink(const Visit& visit, const std::string& next) {
  const std::string address = withQuery(std::string(kOpenIdSignIn), {{"next", next}});
  return element("p", {},
                 element("a", {{"class", "button"}, {"href", address}}, "Sign in with " + visit.options.openId.name));
}

Markup signedOutNote(const Visit& visit) {
  if (valueOf(visit.request.query, "ended") != "openid") return {};
  const std::string& name = visit.options.openId.name;
  Markup content = paragraph("You are signed out of Insonate. Your sign-in with " + name +
                             " continues. On a computer that others use, sign out there, too.");
  if (const std::string address = visit.openId->signOutAddress(); !address.empty())
    content += element("p", {}, link(address, "Sign out of " + name));
  return content;
}

}  // namespace insonate::web
