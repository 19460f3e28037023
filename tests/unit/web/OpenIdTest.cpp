#include "OpenIdRig.h"

#include <insonate/curriculum/AuditLog.h>
#include <insonate/curriculum/BrowserSessions.h>

#include <algorithm>
#include <chrono>
#include <mutex>

namespace insonate::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// A hospital with a provider, a server that uses it, and the lines of the server's log.
struct Hospital {
  explicit Hospital(const CurriculumStore& store) : school(store, optionsOf()) {}

  web::WebOptions optionsOf() {
    web::WebOptions options;
    options.openId = provider.options();
    options.log = [this](web::LogLevel, const std::string& line) { log += line + "\n"; };
    return options;
  }
  /// Each try comes from another address, since failures from one address are limited.
  TestBrowser browser() { return TestBrowser(school.site, "10.0.1." + std::to_string(++browsers)); }

  MadeUpProvider provider;
  std::string log;
  int browsers = 0;
  WebSchool school;
};

class WebOpenId : public OnBoth {};
INSONATE_ON_BOTH(WebOpenId);

TEST_P(WebOpenId, LeadsToThePageThatTheUserAskedFor) {
  Hospital hospital(rig->open());
  TestBrowser browser = hospital.browser();
  const std::string former = hospital.school.signIn("ben");
  browser.cookies["insonate"] = former;
  EXPECT_THAT(browser.get("/sign-in?next=%2Fme%3Flevel%3Dfirst").body,
              HasSubstr("href=\"/sign-in/openid?next=%2Fme%3Flevel%3Dfirst\">Sign in with Test Hospital</a>"));
  const web::Response sent = browser.get("/sign-in/openid?next=%2Fme%3Flevel%3Dfirst");
  EXPECT_THAT(headerOf(sent, "Location"), StartsWith(hospital.provider.issuer + "/authorize?"));
  EXPECT_THAT(headerOf(sent, "Location"),
              HasSubstr("redirect_uri=http%3A%2F%2Finsonate.example%2Fsign-in%2Fopenid%2Freturn"));
  EXPECT_THAT(headerOf(sent, "Set-Cookie"), HasSubstr("; Path=/; HttpOnly; SameSite=Lax; Max-Age=600"));
  const web::Response back = browser.get(hospital.provider.signIn(headerOf(sent, "Location")));
  EXPECT_EQ(back.status, 303) << back.body << hospital.log;
  EXPECT_EQ(headerOf(back, "Location"), "/me?level=first");
  EXPECT_FALSE(browser.cookies.contains("insonate-openid")) << "the cookie is for one return";
  EXPECT_THAT(browser.get("/me").body, HasSubstr("Dr anna"));
  EXPECT_EQ(hospital.school.get("/me", former).status, 303) << "the former session of the browser has ended";
  const AuditEntry entry = valueOf(AuditLog(hospital.school.admin).page(2, 0, hospital.school.anna.id)).back();
  EXPECT_EQ(std::tie(entry.actor, entry.act, entry.detail), std::tuple(hospital.school.anna.id, "sign in", "OpenID"));
}

TEST_P(WebOpenId, AFirstPasswordIsNotAskedFor) {
  Hospital hospital(rig->open());
  valueOf(PeopleStore(hospital.school.admin)
              .add({"dora", "Dora", "dora@example.org"}, "first password", hospital.school.spring.id));
  EXPECT_EQ(headerOf(hospital.school.get("/me", hospital.school.signIn("dora", "first password")), "Location"),
            "/password");
  hospital.provider.claims["email"] = "Dora@Example.org";
  TestBrowser browser = hospital.browser();
  EXPECT_EQ(headerOf(browser.signIn(hospital.provider), "Location"), "/me");
  EXPECT_TRUE(browser.isSignedIn());
}

TEST_P(WebOpenId, AnAccountThatDoesNotFitIsExplained) {
  Hospital hospital(rig->open());
  const auto saidTo = [&](const nlohmann::json& claims) {
    hospital.provider.claims = claims;
    TestBrowser browser = hospital.browser();
    const web::Response back = browser.signIn(hospital.provider);
    EXPECT_EQ(back.status, 403) << claims;
    EXPECT_FALSE(browser.isSignedIn()) << claims;
    EXPECT_TRUE(browser.cookies.empty()) << claims;
    return back.body;
  };
  for (const nlohmann::json& claims : {nlohmann::json{{"email_verified", false}},
                                       {{"email_verified", nullptr}},
                                       {{"email_verified", "true"}},
                                       {{"email_verified", 1}},
                                       {{"email", nullptr}},
                                       {{"email", ""}},
                                       {{"email", {"anna@example.org"}}}})
    EXPECT_THAT(saidTo(claims), HasSubstr("Test Hospital to verify your e-mail address")) << claims;
  EXPECT_THAT(saidTo({{"email", "nobody@example.org"}}), HasSubstr("to enter this address in your account"));
  Person ben = hospital.school.ben;
  ben.disabled = true;
  succeed(PeopleStore(hospital.school.admin).change(ben));
  EXPECT_THAT(saidTo({{"email", "ben@example.org"}}), HasSubstr("Your account is disabled"));
}

TEST(WebOpenIdTokens, OfEachAllowedAlgorithmAndAudienceAreAccepted) {
  const StoreRig rig;
  Hospital hospital(rig.open());
  const auto isAccepted = [&] {
    TestBrowser browser = hospital.browser();
    return browser.signIn(hospital.provider).status == 303 && browser.isSignedIn();
  };
  hospital.provider.sign = [](const std::string& content) { return TestKey::rsa().sign("PS256", content); };
  EXPECT_TRUE(isAccepted()) << hospital.log;
  hospital.provider.sign = [](const std::string& content) { return TestKey::curve().sign("ES256", content); };
  EXPECT_TRUE(isAccepted()) << hospital.log;
  const std::string client = hospital.provider.options().clientId;
  hospital.provider.claims = {{"aud", nlohmann::json::array({client})}};
  EXPECT_TRUE(isAccepted()) << hospital.log;
  hospital.provider.claims = {{"aud", {"other", client}}, {"azp", client}};
  EXPECT_TRUE(isAccepted()) << hospital.log;
  using namespace std::chrono;
  const std::int64_t now_s = duration_cast<seconds>(system_clock::now().time_since_epoch()).count();
  hospital.provider.claims = {{"exp", now_s - 30}, {"iat", now_s + 30}};
  EXPECT_TRUE(isAccepted()) << "clocks may differ; " << hospital.log;
}

/// A token without a signature, or with another one.
std::string unsignedToken(const std::string& header, const std::string& content, const std::string& signature = {}) {
  return base64Url(header) + "." + base64Url(content) + "." + signature;
}

/// The log has the reason, and the page does not sign the user in.
void expectRefused(Hospital& hospital, const std::string& reason) {
  SCOPED_TRACE(reason);
  hospital.log.clear();
  TestBrowser browser = hospital.browser();
  const web::Response back = browser.signIn(hospital.provider);
  EXPECT_EQ(back.status, 502) << back.body;
  EXPECT_THAT(back.body, HasSubstr("Signing in with Test Hospital failed"));
  EXPECT_THAT(hospital.log, HasSubstr(reason));
  EXPECT_TRUE(browser.cookies.empty());
  EXPECT_FALSE(browser.isSignedIn());
}

TEST(WebOpenIdTokens, WithOtherClaimsAreRefused) {
  const StoreRig rig;
  Hospital hospital(rig.open());
  const std::string client = hospital.provider.options().clientId;
  using namespace std::chrono;
  const std::int64_t now_s = duration_cast<seconds>(system_clock::now().time_since_epoch()).count();
  const std::string other = "issued for another program";
  const std::vector<std::pair<nlohmann::json, std::string>> wrong{
      {{{"nonce", "of another sign-in"}}, "belongs to another sign-in"},
      {{{"nonce", nullptr}}, "belongs to another sign-in"},
      {{{"iss", "https://elsewhere.example"}}, "issued by another provider"},
      {{{"iss", hospital.provider.issuer + "/"}}, "issued by another provider"},
      {{{"aud", "other"}}, other},
      {{{"aud", nullptr}}, other},
      {{{"aud", {"other", client}}}, other},
      {{{"aud", {"other", client}}, {"azp", "other"}}, other},
      {{{"azp", "other"}}, other},
      {{{"exp", now_s - 90}}, "has expired"},
      {{{"exp", nullptr}}, "states no times"},
      {{{"exp", "9999999999"}}, "states no times"},
      {{{"iat", nullptr}}, "states no times"},
      {{{"iat", now_s + 90}}, "in the future"},
      {{{"padding", std::string(70'000, 'x')}}, "too long"}};
  for (const auto& [claims, reason] : wrong) {
    hospital.provider.claims = claims;
    expectRefused(hospital, reason);
  }
}

TEST(WebOpenIdTokens, WithOtherSignaturesAreRefused) {
  const StoreRig rig;
  Hospital hospital(rig.open());
  const TestKey open(TestKey::rsa().open().dump());
  const std::string notSigned = "not signed by a key of the provider", algorithm = "not signed with RS256";
  using Sign = std::function<std::string(const std::string&)>;
  const std::vector<std::pair<Sign, std::string>> wrong{
      {[](const auto& content) { return TestKey::otherRsa().sign("RS256", content); }, notSigned},
      {[](const auto& content) { return TestKey::rsa().sign("RS384", content); }, algorithm},
      {[&](const auto& content) { return open.sign("HS256", content); }, algorithm},
      {[](const auto& content) { return unsignedToken(R"({"alg":"none"})", content); }, algorithm},
      {[](const auto& content) { return unsignedToken(R"({"alg":"None","kid":"one"})", content); },
       "damaged, unsigned"},
      {[](const auto& content) { return unsignedToken(R"({"alg":"RS256","kid":"one"})", content, "AAAA"); }, notSigned},
      {[](const auto& content) { return unsignedToken(R"({"alg":"RS256","kid":"one"})", content); }, "ID token"},
      {[](const auto& content) { return TestKey::rsa().sign("RS256", content) + "A"; }, notSigned},
      {[](const auto&) { return "no token"; }, "damaged, unsigned"},
      {[](const auto&) { return ""; }, "sent no ID token"},
      {[](const auto&) { return TestKey::rsa().sign("RS256", "[1]"); }, "contains no claims"},
      {[](const auto&) { return TestKey::rsa().sign("RS256", std::string(5000, '[')); }, "contains no claims"}};
  for (const auto& [sign, reason] : wrong) {
    hospital.provider.sign = sign;
    expectRefused(hospital, reason);
  }
}

TEST(WebOpenIdTokens, ChangedContentWithTheFormerSignatureIsRefused) {
  const StoreRig rig;
  Hospital hospital(rig.open());
  hospital.provider.sign = [](std::string content) {
    const std::string token = TestKey::rsa().sign("RS256", content);
    content.replace(content.find("anna@"), 5, "otto@");
    return token.substr(0, token.find('.') + 1) + base64Url(content) + token.substr(token.rfind('.'));
  };
  expectRefused(hospital, "not signed by a key of the provider");
}

TEST(WebOpenIdKeys, AreReadAgainForAnUnknownKeyOnceAMinute) {
  const StoreRig rig;
  Hospital hospital(rig.open());
  const auto signIn = [&] { return hospital.browser().signIn(hospital.provider).status; };
  EXPECT_EQ(signIn(), 303);
  EXPECT_EQ(signIn(), 303);
  EXPECT_EQ(hospital.provider.keyRequests, 1) << "keys are kept";
  const TestKey renewed(TestKey::Kind::Curve, "three");
  hospital.provider.sign = [&](const std::string& content) { return renewed.sign("ES256", content); };
  hospital.provider.keys["keys"].push_back(renewed.open());
  EXPECT_EQ(signIn(), 303) << hospital.log;
  EXPECT_EQ(hospital.provider.keyRequests, 2);
  const TestKey unknown(TestKey::Kind::Curve, "four");
  hospital.provider.sign = [&](const std::string& content) { return unknown.sign("ES256", content); };
  for (int i = 0; i < 3; ++i) EXPECT_EQ(signIn(), 502);
  EXPECT_EQ(hospital.provider.keyRequests, 2);
}

TEST(WebOpenIdKeys, OfOtherKindsAreNotUsed) {
  nlohmann::json forEncryption = TestKey::rsa().open(), forOther = TestKey::rsa().open();
  forEncryption["use"] = "enc";
  forOther["alg"] = "PS256";
  for (const nlohmann::json& key :
       {forEncryption, forOther, nlohmann::json("text"), nlohmann::json{{"kty", "oct"}, {"k", "AAAA"}}}) {
    const StoreRig rig;
    Hospital hospital(rig.open());
    hospital.provider.keys = {{"keys", nlohmann::json::array({key})}};
    expectRefused(hospital, "not signed by a key");
  }
  const StoreRig nestedRig;
  Hospital nested(nestedRig.open());
  const std::string depth(60'000, '[');
  nested.provider.answers["/keys"] = {.body =
                                          R"({"keys":[{"kty":"RSA","n":)" + depth + std::string(60'000, ']') + "}]}"};
  expectRefused(nested, "not signed by a key");
  for (const std::string answer : {"no JSON", "[]", "{}", "{\"keys\":{}}"}) {
    const StoreRig rig;
    Hospital hospital(rig.open());
    hospital.provider.answers["/keys"] = {.type = "application/json", .body = answer};
    expectRefused(hospital, "keys cannot be read");
  }
}

TEST(WebOpenIdReturn, NeedsTheStateOfThisBrowser) {
  const StoreRig rig;
  Hospital hospital(rig.open());
  TestBrowser browser = hospital.browser(), other = hospital.browser();
  std::string back = browser.atProvider(hospital.provider);
  const web::Response elsewhere = other.get(back);
  EXPECT_EQ(elsewhere.status, 400) << "without a cookie";
  EXPECT_THAT(elsewhere.body, HasSubstr("Begin the sign-in again"));
  const std::string others = other.atProvider(hospital.provider);
  EXPECT_EQ(other.get(back).status, 400) << "with the cookie of another sign-in";
  const std::string cookie = browser.cookies["insonate-openid"];
  EXPECT_EQ(browser.get(back.substr(0, back.find("&state"))).status, 400) << "without a state";
  browser.cookies["insonate-openid"] = cookie;
  EXPECT_EQ(browser.get(back + "x").status, 400) << "with another state";
  browser.cookies["insonate-openid"] = cookie;
  EXPECT_EQ(browser.get(back + "&iss=https%3A%2F%2Felsewhere.example").status, 400) << "from another provider";
  browser.cookies["insonate-openid"] = cookie;
  EXPECT_EQ(browser.get("/sign-in/openid/return?state=" + back.substr(back.find("&state=") + 7)).status, 400)
      << "without a code";
  EXPECT_EQ(hospital.provider.tokenRequests, 0);
  browser.cookies["insonate-openid"] = cookie;
  EXPECT_EQ(browser.get(back).status, 303) << hospital.log;
}

TEST(WebOpenIdReturn, CodesAndCookiesAreForOneSignIn) {
  const StoreRig rig;
  Hospital hospital(rig.open());
  TestBrowser browser = hospital.browser();
  const std::string back = browser.atProvider(hospital.provider);
  const std::string cookie = browser.cookies["insonate-openid"];
  EXPECT_EQ(browser.get(back).status, 303);
  EXPECT_EQ(browser.get(back).status, 400) << "the cookie was deleted";
  TestBrowser thief = hospital.browser();
  thief.cookies["insonate-openid"] = cookie;
  EXPECT_EQ(thief.get(back).status, 502) << "the provider redeems a code once";
  EXPECT_THAT(hospital.log, HasSubstr("(invalid_grant)"));
  EXPECT_FALSE(thief.isSignedIn());
  EXPECT_TRUE(browser.isSignedIn());
}

TEST(WebOpenIdReturn, CookiesEndAfterTenMinutes) {
  const StoreRig rig;
  Hospital hospital(rig.open());
  const auto statusAfter = [&](std::int64_t age_s) {
    TestBrowser browser = hospital.browser();
    const std::string back = browser.atProvider(hospital.provider);
    std::string& cookie = browser.cookies["insonate-openid"];
    std::size_t begun = 0;
    for (int i = 0; i < 3; ++i) begun = cookie.find('.', begun) + 1;
    const std::size_t end = cookie.find('.', begun);
    cookie.replace(begun, end - begun, std::to_string(std::stoll(cookie.substr(begun, end - begun)) - age_s));
    return browser.get(back).status;
  };
  EXPECT_EQ(statusAfter(590), 303);
  EXPECT_EQ(statusAfter(602), 400);
  EXPECT_EQ(statusAfter(-300), 400) << "from the future";
  for (const std::string& damaged :
       {std::string(), std::string("a.b.c.1./me"), std::string("...."), std::string(200, 'x')}) {
    TestBrowser browser = hospital.browser();
    const std::string back = browser.atProvider(hospital.provider);
    browser.cookies["insonate-openid"] = damaged;
    EXPECT_EQ(browser.get(back).status, 400) << damaged;
  }
}

TEST(WebOpenIdReturn, LeadsNowhereElse) {
  const StoreRig rig;
  Hospital hospital(rig.open());
  for (const std::string next : {"//elsewhere.example", "/\\elsewhere.example", "https://elsewhere.example", "",
                                 "javascript:alert(1)", "/\t/elsewhere.example", "/x\r\nSet-Cookie: a=b"})
    EXPECT_EQ(headerOf(hospital.browser().signIn(hospital.provider, next), "Location"), "/") << next;
  EXPECT_EQ(headerOf(hospital.browser().signIn(hospital.provider, "/" + std::string(4000, 'x')), "Location"), "/");
  TestBrowser browser = hospital.browser();
  const std::string back = browser.atProvider(hospital.provider);
  std::string& cookie = browser.cookies["insonate-openid"];
  cookie = cookie.substr(0, cookie.rfind('.')) + ".%2F%2Felsewhere.example";
  EXPECT_EQ(headerOf(browser.get(back), "Location"), "/") << "the cookie was changed";
}

TEST(WebOpenIdReturn, ARefusalOfTheProviderIsTold) {
  const StoreRig rig;
  Hospital hospital(rig.open());
  TestBrowser browser = hospital.browser();
  std::string back = browser.atProvider(hospital.provider);
  back = "/sign-in/openid/return?error=access_denied" + back.substr(back.find("&state="));
  EXPECT_THAT(browser.get(back).body, HasSubstr("Test Hospital did not sign you in"));
  EXPECT_EQ(hospital.provider.tokenRequests, 0);
}

TEST(WebOpenIdReturn, FailuresOfAnAddressAreLimited) {
  const StoreRig rig;
  Hospital hospital(rig.open());
  TestBrowser browser(hospital.school.site, "10.0.2.1");
  for (int i = 0; i < 40; ++i)
    EXPECT_EQ(browser.get("/sign-in/openid/return?code=1&state=1").status, 400)
        << "can come from a page of another site";
  EXPECT_EQ(browser.signIn(hospital.provider).status, 303);
  for (int i = 0; i < 30; ++i) {
    const std::string back = browser.atProvider(hospital.provider);
    EXPECT_EQ(browser.get("/sign-in/openid/return?code=guessed" + back.substr(back.find("&state="))).status, 502);
  }
  const web::Response refused = browser.signIn(hospital.provider);
  EXPECT_EQ(refused.status, 429);
  EXPECT_THAT(refused.body, HasSubstr("too many failed sign-ins from this network address"));
  EXPECT_EQ(hospital.browser().signIn(hospital.provider).status, 303) << "from another address";
}

TEST(WebOpenIdReturn, AnOutageOfTheProviderDoesNotLockPasswords) {
  const StoreRig rig;
  Hospital hospital(rig.open());
  TestBrowser browser(hospital.school.site, "10.0.2.2");
  hospital.provider.answers["/token"] = {.status = 401};
  for (int i = 0; i < 31; ++i) (void)browser.signIn(hospital.provider);
  EXPECT_EQ(browser.signIn(hospital.provider).status, 429);
  EXPECT_EQ(browser.post("/sign-in", {{"name", "ben"}, {"password", kPassword}}).status, 303);
  EXPECT_TRUE(browser.isSignedIn());
}

TEST(WebOpenIdLog, HasNoPersonalData) {
  const StoreRig rig;
  Hospital hospital(rig.open());
  std::vector<std::string> secrets{"anna", "example.org", "code 1", "10.0.1."};
  for (const nlohmann::json& claims : {nlohmann::json{{"nonce", "n"}},
                                       {{"email_verified", false}},
                                       {{"email", "anna.other@example.org"}},
                                       nlohmann::json::object()}) {
    hospital.provider.claims = claims;
    TestBrowser browser = hospital.browser();
    const std::string back = browser.atProvider(hospital.provider);
    secrets.push_back(back.substr(back.find("&state=") + 7));
    (void)browser.get(back);
  }
  EXPECT_THAT(hospital.log, HasSubstr(R"({"event":"openid failure","route":"/sign-in/openid/return","message":")"));
  for (const std::string& secret : secrets) EXPECT_THAT(hospital.log, Not(HasSubstr(secret)));
}

TEST(WebOpenIdSignOut, EndsOurSessionAndNamesTheOther) {
  const StoreRig rig;
  Hospital hospital(rig.open());
  hospital.provider.metadata["end_session_endpoint"] = hospital.provider.issuer + "/logout?a=b";
  TestBrowser browser = hospital.browser();
  EXPECT_EQ(browser.signIn(hospital.provider).status, 303);
  const web::Response out = browser.post("/sign-out", {});
  EXPECT_FALSE(browser.isSignedIn());
  const web::Response after = browser.get(headerOf(out, "Location"));
  EXPECT_THAT(after.body, HasSubstr("Your sign-in with Test Hospital continues"));
  EXPECT_THAT(after.body,
              HasSubstr("href=\"" + hospital.provider.issuer + "/logout?a=b&amp;client_id=insonate%20at%20work\""));
  TestBrowser byPassword = hospital.browser();
  byPassword.cookies["insonate"] = hospital.school.signIn("ben");
  EXPECT_EQ(headerOf(byPassword.post("/sign-out", {}), "Location"), "/sign-in");
}

TEST(WebOpenIdCookies, AreForHttpsBehindAProxy) {
  const StoreRig rig;
  MadeUpProvider provider;
  const WebSchool school(rig.open());
  web::WebOptions options;
  options.behindProxy = true;
  options.openId = provider.options();
  const web::Site site(rig.open(), options);
  TestBrowser browser(site);
  const web::Response sent = browser.get("/sign-in/openid");
  EXPECT_THAT(headerOf(sent, "Set-Cookie"), StartsWith("__Host-insonate-openid="));
  EXPECT_THAT(headerOf(sent, "Set-Cookie"), testing::EndsWith("; Secure"));
  EXPECT_THAT(headerOf(sent, "Location"), HasSubstr("redirect_uri=https%3A%2F%2Finsonate.example%2F"));
  EXPECT_EQ(browser.get(provider.signIn(headerOf(sent, "Location"))).status, 303);
  EXPECT_TRUE(browser.cookies.contains("__Host-insonate"));
  web::Request forged = WebSchool::request("GET", "/sign-in/openid", "");
  forged.headers["host"] = "insonate.example/elsewhere?";
  EXPECT_EQ(site.answer(forged).status, 400);
}

TEST(WebOpenIdOff, NothingChanges) {
  const StoreRig rig;
  const WebSchool school(rig.open());
  EXPECT_THAT(school.get("/sign-in").body, Not(HasSubstr("Sign in with")));
  for (const std::string path : {"/sign-in/openid", "/sign-in/openid/return?code=1&state=1"})
    for (const std::string& secret : {std::string(), school.signIn("anna"), school.signIn("admin")})
      EXPECT_EQ(school.get(path, secret).status, 404) << path;
  EXPECT_EQ(headerOf(school.post("/sign-out", {}, school.signIn("anna")), "Location"), "/sign-in");
}

}  // namespace
}  // namespace insonate::test
