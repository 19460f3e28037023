#include "WebRig.h"
#include "page/Page.h"

#include <insonate/curriculum/AuditLog.h>
#include <insonate/curriculum/BrowserSessions.h>
#include <insonate/curriculum/Workstations.h>

namespace insonate::test {

web::Request WebSchool::request(const std::string& method, const std::string& path, const std::string& secret) {
  web::Request made{.method = method, .path = path.substr(0, path.find('?')), .client = "10.0.0.7"};
  if (const auto query = path.find('?'); query != std::string::npos)
    made.query = web::fieldsOfForm(path.substr(query + 1));
  if (!secret.empty()) made.cookies["insonate"] = secret;
  return made;
}

web::Request WebSchool::fromHere(const std::string& path) {
  web::Request made = request("GET", path, "");
  made.client = "127.0.0.1";
  made.headers["host"] = "127.0.0.1:8443";
  return made;
}

web::Response WebSchool::post(const std::string& path, web::Fields form, const std::string& secret) const {
  web::Request made = request("POST", path, secret);
  if (!secret.empty()) form.emplace("code", web::formCode(secret));
  made.form = std::move(form);
  made.headers["sec-fetch-site"] = "same-origin";
  return site.answer(made);
}

std::string WebSchool::signIn(const std::string& name, const std::string& password) const {
  const std::string cookie = headerOf(post("/sign-in", {{"name", name}, {"password", password}}), "Set-Cookie");
  const std::size_t equals = cookie.find('=');
  return cookie.substr(equals + 1, cookie.find(';') - equals - 1);
}

namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class WebSite : public OnBoth {};
INSONATE_ON_BOTH(WebSite);

TEST_P(WebSite, EachLookAtOthersIsInTheAuditLog) {
  const WebSchool school(rig->open());
  const std::string ina = school.signIn("ina"), otto = school.signIn("otto");
  school.get("/classes/" + school.spring.id + "/people/" + school.anna.id, ina);
  school.get("/attempts/" + school.annas, otto);
  const auto entries = valueOf(AuditLog(school.admin).page(20, 0, school.anna.id));
  const auto by = [&](const Person& person, bool allowed) {
    return std::ranges::count_if(
        entries, [&](const AuditEntry& entry) { return entry.actor == person.id && entry.allowed == allowed; });
  };
  EXPECT_GE(by(school.ina, true), 2);
  EXPECT_EQ(by(school.otto, false), 1);
}

TEST_P(WebSite, ASessionBeginsNewWithEachSignIn) {
  const WebSchool school(rig->open());
  const std::string before = school.signIn("anna");
  const web::Response again = school.post("/sign-in", {{"name", "ben"}, {"password", kPassword}}, before);
  EXPECT_EQ(again.status, 303);
  EXPECT_THAT(headerOf(again, "Set-Cookie"), Not(HasSubstr(before)));
  EXPECT_EQ(school.get("/me", before).status, 303) << "the session of the browser before has ended";
  const std::string chosen(64, 'a');
  EXPECT_EQ(school.post("/sign-in", {{"name", "ben"}, {"password", kPassword}}, chosen).status, 303);
  EXPECT_EQ(school.get("/me", chosen).status, 303) << "nobody can choose the secret of another's session";
  const web::Response wrong = school.post("/sign-in", {{"name", "ben"}, {"password", "wrong password"}});
  EXPECT_EQ(wrong.status, 401);
  EXPECT_THAT(headerOf(wrong, "Set-Cookie"), "");
  EXPECT_THAT(wrong.body, HasSubstr("value=\"ben\"")) << "the name stays in its field";
  EXPECT_THAT(wrong.body, Not(HasSubstr("wrong password\"")));
}

TEST_P(WebSite, SigningOutEndsTheSessionAtTheServer) {
  const WebSchool school(rig->open());
  const std::string anna = school.signIn("anna");
  const web::Response out = school.post("/sign-out", {}, anna);
  EXPECT_THAT(headerOf(out, "Set-Cookie"), HasSubstr("Max-Age=0"));
  EXPECT_EQ(school.get("/me", anna).status, 303);
}

TEST_P(WebSite, FormsFromElsewhereAreRefused) {
  const WebSchool school(rig->open());
  const std::string anna = school.signIn("anna"), ben = school.signIn("ben");
  web::Request forged = WebSchool::request("POST", "/sign-out", anna);
  EXPECT_EQ(school.site.answer(forged).status, 403) << "without a code";
  forged.form = {{"code", web::formCode(ben)}};
  EXPECT_EQ(school.site.answer(forged).status, 403) << "with the code of another session";
  forged.form = {{"code", web::formCode(anna)}};
  forged.headers = {{"sec-fetch-site", "cross-site"}};
  EXPECT_EQ(school.site.answer(forged).status, 403);
  forged.headers = {{"origin", "https://elsewhere.example"}, {"host", "insonate.example"}};
  EXPECT_EQ(school.site.answer(forged).status, 403);
  forged.headers = {{"origin", "null"}, {"host", "insonate.example"}};
  EXPECT_EQ(school.site.answer(forged).status, 403);
  EXPECT_EQ(school.get("/me", anna).status, 200) << "nothing happened";
  forged.headers = {{"origin", "https://insonate.example"}, {"host", "insonate.example"}};
  EXPECT_EQ(school.site.answer(forged).status, 303);
  EXPECT_NE(web::formCode(anna), anna);
}

TEST_P(WebSite, LargeBodiesAreForWorkstationsAndSignedInUsers) {
  const WebSchool school(rig->open());
  const auto statusOf = [&](web::Request request) {
    const auto refusal = school.site.admit(request);
    return refusal ? refusal->status : 200;
  };
  const auto fromWorkstation = [&](const std::string& token) {
    web::Request request = WebSchool::request("POST", "/api/site/facts", "");
    request.headers["authorization"] = token;
    return statusOf(request);
  };
  const std::string token = valueOf(Workstations(school.admin).add("ward 7"));
  EXPECT_EQ(fromWorkstation("Bearer " + token), 200);
  EXPECT_EQ(fromWorkstation(token), 401);
  EXPECT_EQ(fromWorkstation("Bearer " + token.substr(1)), 401);
  succeed(Workstations(school.admin).revoke("ward 7"));
  EXPECT_EQ(fromWorkstation("Bearer " + token), 401);
  const std::string import = "/classes/" + school.spring.id + "/import", ina = school.signIn("ina");
  EXPECT_EQ(statusOf(WebSchool::request("POST", import, ina)), 200);
  EXPECT_EQ(statusOf(WebSchool::request("POST", import, "forged")), 403);
  (void)school.post("/sign-out", {}, ina);
  EXPECT_EQ(statusOf(WebSchool::request("POST", import, ina)), 403);
  EXPECT_EQ(statusOf(WebSchool::request("POST", "/api/site/facts/more", "")), 404);
}

TEST_P(WebSite, AFirstPasswordIsChangedBeforeAnythingElse) {
  const WebSchool school(rig->open());
  valueOf(PeopleStore(school.admin).add({"dora", "Dora"}, "first password", school.spring.id));
  const std::string dora = school.signIn("dora", "first password");
  EXPECT_EQ(headerOf(school.get("/me", dora), "Location"), "/password");
  EXPECT_EQ(headerOf(school.get("/attempts/" + school.annas, dora), "Location"), "/password");
  const auto change = [&](const std::string& old, const std::string& to, const std::string& again) {
    return school.post("/password", {{"old", old}, {"new", to}, {"again", again}}, dora);
  };
  EXPECT_THAT(change("first password", "second password", "other password").body, HasSubstr("differ"));
  EXPECT_THAT(change("first password", "short", "short").body, HasSubstr("8 to 200"));
  EXPECT_EQ(change("wrong password", "second password", "second password").status, 400);
  EXPECT_EQ(change("first password", "second password", "second password").status, 303);
  EXPECT_EQ(school.get("/me", dora).status, 200) << "the session goes on";
}

TEST_P(WebSite, AddressesLeadNowhereElse) {
  const WebSchool school(rig->open());
  EXPECT_EQ(headerOf(school.get("/me"), "Location"), "/sign-in?next=%2Fme");
  const std::string asked = headerOf(school.get("/me?level=first&metric=a%20%26b"), "Location");
  EXPECT_EQ(asked, "/sign-in?next=%2Fme%3Flevel%3Dfirst%26metric%3Da%2520%2526b");
  const auto after = [&](const std::string& next) {
    const web::Fields form{{"name", "anna"}, {"password", kPassword}, {"next", next}};
    return headerOf(school.post("/sign-in", form), "Location");
  };
  EXPECT_EQ(after("/classes/5"), "/classes/5");
  EXPECT_EQ(after(web::decoded(asked.substr(asked.find('=') + 1), false)), "/me?level=first&metric=a%20%26b");
  EXPECT_EQ(headerOf(school.get("//elsewhere.example"), "Location"), "") << "is not a page";
  for (const std::string next : {"//elsewhere.example", "/\\elsewhere.example", "https://elsewhere.example", "",
                                 "javascript:alert(1)", "/\t/elsewhere.example", "/x\x7F", "/x\r\nSet-Cookie: a=b"})
    EXPECT_EQ(after(next), "/") << next;
  const std::string anna = school.signIn("anna");
  for (const std::string path : {"/style.css/../../etc/passwd", "/../etc/passwd", "/classes/../../etc/passwd", "//",
                                 "/attempts/", "/attempts", "/.env", "/sign-in/x"})
    EXPECT_EQ(school.get(path, anna).status, 404) << path;
  EXPECT_EQ(school.get("/attempts/' OR 1=1 --", anna).status, 404);
  EXPECT_EQ(school.get("/sign-out", anna).status, 405);
  EXPECT_EQ(school.post("/me", {}, anna).status, 405);
  EXPECT_EQ(school.site.answer(WebSchool::request("DELETE", "/me", anna)).status, 405);
}

TEST_P(WebSite, CookiesAndPagesAreProtected) {
  const CurriculumStore store = rig->open();
  const WebSchool school(store);
  const web::Response plain = school.post("/sign-in", {{"name", "anna"}, {"password", kPassword}});
  EXPECT_THAT(headerOf(plain, "Set-Cookie"), HasSubstr("HttpOnly; SameSite=Lax"));
  EXPECT_THAT(headerOf(plain, "Set-Cookie"), Not(HasSubstr("Secure"))) << "a loopback address has no HTTPS";
  const web::Site behind(store, {.behindProxy = true});
  web::Request request = WebSchool::request("POST", "/sign-in", "");
  request.form = {{"name", "anna"}, {"password", kPassword}};
  const web::Response secure = behind.answer(request);
  EXPECT_THAT(headerOf(secure, "Set-Cookie"), testing::StartsWith("__Host-insonate="));
  EXPECT_THAT(headerOf(secure, "Set-Cookie"), HasSubstr("; Secure"));
  EXPECT_THAT(headerOf(secure, "Strict-Transport-Security"), HasSubstr("max-age"));
  for (const std::string path : {"/sign-in", "/nowhere", "/me"}) {
    const web::Response response = school.get(path);
    EXPECT_THAT(headerOf(response, "Content-Security-Policy"), HasSubstr("default-src 'none'")) << path;
    EXPECT_EQ(headerOf(response, "Cache-Control"), "no-store") << path;
  }
  EXPECT_THAT(headerOf(school.get("/style.css"), "Cache-Control"), HasSubstr("max-age"));
}

TEST(WebSiteFirstRun, ADatabaseWithoutAccountsSaysHowToBegin) {
  const StoreRig rig;
  const web::Site site(rig.open(), {});
  const web::Response response = site.answer(WebSchool::request("GET", "/sign-in", ""));
  EXPECT_EQ(response.status, 503);
  EXPECT_THAT(response.body, HasSubstr("has no accounts yet"));
  EXPECT_EQ(site.answer(WebSchool::fromHere("/health")).status, 200);
}

}  // namespace
}  // namespace insonate::test
