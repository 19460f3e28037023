#include "WebRig.h"
#include "monitoring/FailureLog.h"
#include "monitoring/Metrics.h"

#include <nlohmann/json.hpp>

#include <filesystem>

namespace insonate::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(WebMetrics, CountRequestsByRouteAndStatusWithTheirTimes) {
  web::Metrics metrics;
  metrics.count("GET", "/me", 200, 0.02);
  metrics.count("GET", "/me", 200, 0.7);
  metrics.count("GET", "/me", 503, 9);
  metrics.count("POST", "/sign-in", 401, 0.1);
  metrics.countDatabaseFailures(2);
  const std::string text = metrics.text();
  for (const std::string line :
       {"insonate_requests_total{method=\"GET\",route=\"/me\",status=\"200\"} 2\n",
        "insonate_requests_total{method=\"GET\",route=\"/me\",status=\"503\"} 1\n",
        "insonate_requests_total{method=\"POST\",route=\"/sign-in\",status=\"401\"} 1\n",
        "insonate_request_seconds_bucket{route=\"/me\",le=\"0.01\"} 0\n",
        "insonate_request_seconds_bucket{route=\"/me\",le=\"0.05\"} 1\n",
        "insonate_request_seconds_bucket{route=\"/me\",le=\"1\"} 2\n",
        "insonate_request_seconds_bucket{route=\"/me\",le=\"+Inf\"} 3\n",
        "insonate_request_seconds_sum{route=\"/me\"} 9.72\n", "insonate_request_seconds_count{route=\"/me\"} 3\n",
        "insonate_request_seconds_bucket{route=\"/sign-in\",le=\"0.1\"} 1\n", "insonate_database_failures_total 2\n"})
    EXPECT_THAT(text, HasSubstr("\n" + line));
}

TEST(WebFailureLog, IsOneObjectWhateverTheSentenceContains) {
  std::vector<std::string> objects;
  const web::Log log = [&](web::LogLevel level, const std::string& object) {
    EXPECT_EQ(level, web::LogLevel::Error);
    objects.push_back(object);
  };
  web::logFailure(log, "video failed", "\"a\" \xFF\nb");
  ASSERT_EQ(objects.size(), 1u);
  EXPECT_EQ(objects[0].find('\n'), std::string::npos) << "one line";
  const auto read = nlohmann::json::parse(objects[0]);
  EXPECT_EQ(read.at("event"), "video failed");
  EXPECT_EQ(read.at("message"), "\"a\" \xEF\xBF\xBD\nb");
  web::logFailure({}, "video failed", "nothing receives this");
}

TEST(WebMonitoring, IsForProgramsOnThisComputerAndThoseWithTheToken) {
  const StoreRig rig;
  const std::string token = "0123456789abcdef";
  const WebSchool open(rig.open(), {.monitoringToken = token});
  const web::Site closed(rig.open(), {});
  web::Request far = WebSchool::request("GET", "/metrics", open.signIn("admin"));
  for (const std::string path : {"/metrics", "/health"}) {
    far.path = path;
    far.headers.clear();
    EXPECT_EQ(open.site.answer(far).status, 403) << "an administrator is not a monitor";
    for (const std::string wrong : {"Bearer ", "Bearer 0123456789abcdeX", "0123456789abcdef", ""}) {
      far.headers["authorization"] = wrong;
      EXPECT_EQ(open.site.answer(far).status, 403) << wrong;
      EXPECT_EQ(closed.answer(far).status, 403) << wrong;
    }
    far.headers["authorization"] = "Bearer " + token;
    EXPECT_EQ(open.site.answer(far).status, 200);
    EXPECT_EQ(closed.answer(far).status, 403) << "no token is set";
    EXPECT_EQ(closed.answer(WebSchool::fromHere(path)).status, 200);
  }
}

TEST(WebMonitoring, ShowsSessionsAndLastsWithoutTheDatabase) {
  const StoreRig rig;
  const WebSchool school(rig.open());
  (void)school.signIn("anna");
  (void)school.signIn("ina");
  EXPECT_THAT(school.site.answer(WebSchool::fromHere("/metrics")).body, HasSubstr("\ninsonate_sessions 2\n"));
  EXPECT_THAT(school.site.answer(WebSchool::fromHere("/metrics")).body,
              HasSubstr("\ninsonate_verifications_waiting 0\n"));
  std::filesystem::remove(rig.address);
  EXPECT_EQ(school.site.answer(WebSchool::fromHere("/health")).status, 503);
  EXPECT_EQ(school.get("/sign-in").status, 503);
  const web::Response response = school.site.answer(WebSchool::fromHere("/metrics"));
  EXPECT_EQ(response.status, 200);
  EXPECT_THAT(response.body,
              AllOf(Not(HasSubstr("insonate_sessions")), HasSubstr("insonate_database_failures_total 2")));
  EXPECT_EQ(school.get("/style.css").status, 200);
}

TEST(WebLog, HasOneObjectARequestAndNoPersonalData) {
  const StoreRig rig;
  std::vector<std::pair<web::LogLevel, std::string>> log;
  web::WebOptions options;
  options.log = [&](web::LogLevel level, const std::string& object) { log.emplace_back(level, object); };
  const WebSchool school(rig.open(), options);
  const std::string ina = school.signIn("ina");
  school.get("/attempts/" + school.annas + "?class=" + school.spring.id, ina);
  school.get("/classes/" + school.spring.id + "/people/" + school.anna.id, ina);
  school.get("/anna?q=anna", ina);
  school.site.answer(WebSchool::request("ANNA", "/me", ina));
  ASSERT_EQ(log.size(), 5U);
  for (const auto& [level, object] : log) {
    EXPECT_EQ(level, web::LogLevel::Info);
    for (const std::string& personal : {std::string("anna"), std::string("ANNA"), std::string("ina\""), school.annas,
                                        school.anna.id, school.spring.id, std::string("10.0.0"), ina, kPassword})
      EXPECT_THAT(object, Not(HasSubstr(personal)));
  }
  const auto entry = nlohmann::json::parse(log[1].second);
  EXPECT_EQ(entry["event"], "request");
  EXPECT_EQ(entry["route"], "/attempts/*");
  EXPECT_EQ(entry["status"], 200);
  EXPECT_TRUE(entry["ms"].is_number());
  EXPECT_EQ(nlohmann::json::parse(log[3].second)["route"], "other");
  EXPECT_EQ(nlohmann::json::parse(log[4].second)["method"], "other");
  school.site.noteRefused(413);
  EXPECT_EQ(nlohmann::json::parse(log[5].second)["route"], "refused");
  EXPECT_THAT(school.site.answer(WebSchool::fromHere("/metrics")).body,
              HasSubstr("{method=\"other\",route=\"refused\",status=\"413\"} 1\n"));
}

TEST(WebLog, AFailureOfTheDatabaseIsLoggedWithItsPlace) {
  const StoreRig rig;
  std::vector<std::string> errors;
  web::WebOptions options;
  options.log = [&](web::LogLevel level, const std::string& object) {
    if (level == web::LogLevel::Error) errors.push_back(object);
  };
  const WebSchool school(rig.open(), options);
  std::filesystem::remove(rig.address);
  school.get("/sign-in");
  ASSERT_FALSE(errors.empty());
  const auto entry = nlohmann::json::parse(errors.front());
  EXPECT_EQ(entry["event"], "database failure");
  EXPECT_EQ(entry["route"], "/sign-in");
  EXPECT_THAT(entry["message"].get<std::string>(), HasSubstr(rig.address + " was deleted"));
}

}  // namespace
}  // namespace insonate::test
