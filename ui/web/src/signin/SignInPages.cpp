#include "signin/SignInPages.h"

#include "http/ClientAddress.h"
#include "openid/OpenIdPages.h"

#include <insonate/curriculum/BrowserSessions.h>
#include <insonate/curriculum/PeopleStore.h>

#include <algorithm>

namespace insonate::web {
namespace {

Response signInPage(const Visit& visit, const std::string& trouble, int status) {
  if (const auto people = visit.store.hasPeople(); people && !*people)
    return refusal(visit, 503,
                   "This database has no accounts yet. Create the first administrator with insonate-cli curriculum "
                   "setup, or on a workstation that opens this database.");
  Markup fields;
  if (!trouble.empty()) fields += troubleLine(trouble);
  fields += inputField("Sign-in name", "name", "text", "username", valueOf(visit.request.form, "name")) +
            inputField("Password", "password", "password", "current-password");
  const std::string& asked = valueOf(visit.request.method == "POST" ? visit.request.form : visit.request.query, "next");
  fields += element("input", {{"type", "hidden"}, {"name", "next"}, {"value", localAddress(asked)}});
  const Markup form = postForm(visit, "/sign-in", fields, "Sign in");
  const Markup content = visit.openId ? signedOutNote(visit) + form + providerLink(visit, localAddress(asked)) : form;
  return page(visit, "Sign in", content, status);
}

Response passwordPage(const Visit& visit, const std::string& trouble, int status) {
  // Password managers need the name beside the passwords.
  Markup fields = element("input", {{"type", "text"},
                                    {"name", "username"},
                                    {"value", visit.by->person().name},
                                    {"autocomplete", "username"},
                                    {"hidden", ""}});
  if (visit.by->mustChangePassword())
    fields += paragraph("Your password was set by another person. Choose a password that only you know.");
  if (!trouble.empty()) fields += troubleLine(trouble);
  fields += inputField("Current password", "old", "password", "current-password") +
            inputField("New password (8 to 200 characters)", "new", "password", "new-password") +
            inputField("New password again", "again", "password", "new-password");
  return page(visit, "Change password", postForm(visit, "/password", fields, "Change password"), status);
}

}  // namespace

bool hasHttps(const WebOptions& options) {
  return options.behindProxy || !options.certificate.empty();
}

std::pair<std::string, std::string> sessionHeader(const WebOptions& options, const std::string& secret) {
  std::string value = sessionCookie(options) + "=" + secret + "; Path=/; HttpOnly; SameSite=Lax";
  if (secret.empty()) value += "; Max-Age=0";
  if (hasHttps(options)) value += "; Secure";
  return {"Set-Cookie", value};
}

std::string localAddress(const std::string& next) {
  // "//host" and "/\\host" would lead elsewhere, also with a tab between, which browsers leave out.
  const bool isLocal = next.starts_with('/') && !next.starts_with("//") && next.find('\\') == std::string::npos &&
                       std::ranges::none_of(next, [](unsigned char c) { return c <= 0x20 || c == 0x7F; });
  return isLocal ? next : "/";
}

std::string sessionCookie(const WebOptions& options) {
  return hasHttps(options) ? "__Host-insonate" : "insonate";
}

Response showSignIn(const Visit& visit, const Parts& /*parts*/) {
  return signInPage(visit, "", 200);
}

Response signIn(const Visit& visit, const Parts& /*parts*/) {
  const Fields& form = visit.request.form;
  const BrowserSessions sessions(visit.store);
  const std::string address = networkOf(clientAddress(visit.request, visit.options));
  const auto by = sessions.signIn(valueOf(form, "name"), valueOf(form, "password"), address);
  if (!by) return signInPage(visit, by.error().message, 401);
  const auto secret = sessions.begin(*by);
  if (!secret) return signInPage(visit, secret.error().message, 503);
  // A session that the browser had before ends, so that nobody continues it.
  if (!visit.secret.empty()) (void)sessions.end(visit.secret);
  Response response = redirect(by->mustChangePassword() ? "/password" : localAddress(valueOf(form, "next")));
  response.headers.push_back(sessionHeader(visit.options, *secret));
  return response;
}

Response signOut(const Visit& visit, const Parts& /*parts*/) {
  if (const auto ended = BrowserSessions(visit.store).end(visit.secret); !ended)
    return refusal(visit, 503, ended.error().message);
  const bool isByProvider = visit.openId && BrowserSessions::isByProvider(visit.secret);
  Response response = redirect(isByProvider ? kSignedOutOfProvider : "/sign-in");
  response.headers.push_back(sessionHeader(visit.options, ""));
  return response;
}

Response showPasswordForm(const Visit& visit, const Parts& /*parts*/) {
  return passwordPage(visit, "", 200);
}

Response changePassword(const Visit& visit, const Parts& /*parts*/) {
  const Fields& form = visit.request.form;
  if (valueOf(form, "new") != valueOf(form, "again"))
    return passwordPage(visit, "The two new passwords differ. Enter the same password twice.", 400);
  if (auto changed = PeopleStore(*visit.by).changeOwnPassword(valueOf(form, "old"), valueOf(form, "new")); !changed)
    return passwordPage(visit, changed.error().message, 400);
  if (auto kept = BrowserSessions(visit.store).keepAfterPasswordChange(visit.secret); !kept)
    return refusal(visit, 503, kept.error().message);
  return redirect("/");
}

}  // namespace insonate::web
