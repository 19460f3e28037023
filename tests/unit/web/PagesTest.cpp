#include "WebRig.h"
#include "page/Charts.h"
#include "page/Page.h"

#include <insonate/curriculum/SiteService.h>
#include <insonate/curriculum/Unlocking.h>
#include <insonate/teaching/HeatMap.h>

#include <QDateTime>
#include <algorithm>

namespace insonate::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class WebPages : public OnBoth {};
INSONATE_ON_BOTH(WebPages);

TEST_P(WebPages, OwnTrainingGivesEachLevelWithItsReasonAndItsFewestAttempts) {
  const WebSchool school(rig->open());
  const std::string page = school.get("/me", school.signIn("anna")).body;
  const Curriculum curriculum = valueOf(loadCurriculum("central_line"));
  const auto progress =
      computeProgress(curriculum, valueOf(AttemptStore(school.as(school.anna)).history(school.anna.id)), rig->now_us);
  for (const LevelProgress& one : progress) EXPECT_THAT(page, HasSubstr(web::text(one.why).html()));
  EXPECT_THAT(page,
              HasSubstr("Mastery takes at least " + std::to_string(fewestAttempts(curriculum.levels[0].mastery))));
  EXPECT_THAT(page, HasSubstr("/attempts/" + school.annas)) << "the attempts lead to their results";
}

TEST_P(WebPages, AnAttemptSaysWhatItsLevelAsksFor) {
  const WebSchool school(rig->open());
  const std::string page = school.get("/attempts/" + school.annas, school.signIn("anna")).body;
  EXPECT_THAT(page, AllOf(HasSubstr("Failed because"), HasSubstr("81.3"), HasSubstr("Vein punctures")));
  EXPECT_THAT(page, Not(HasSubstr("Implausible"))) << "flags are for instructors";
}

TEST_P(WebPages, ATestThatWasNotOpenIsPractice) {
  const WebSchool school(rig->open());
  const Curriculum curriculum = valueOf(loadCurriculum("central_line"));
  AttemptFacts facts = begunFacts();
  facts.curriculumVersion = curriculum.version, facts.level = "jugular_test";
  facts.procedure = curriculum.level("jugular_test")->procedure, facts.testConditions = TestConditions::Opened;
  const std::string id = keepAttempt(school.as(school.anna), facts).id, secret = school.signIn("anna");
  const std::string attempt = school.get("/attempts/" + id, secret).body;
  EXPECT_THAT(attempt, HasSubstr("<dt>Test</dt><dd>practice</dd>"));
  EXPECT_THAT(attempt, HasSubstr("Practice, the test was not open: would fail"));
  EXPECT_THAT(school.get("/me", secret).body, HasSubstr("an attempt counts if an instructor has opened the test"));
  EXPECT_THAT(school.get("/attempts/" + school.annas, secret).body, Not(HasSubstr("<dt>Test</dt>")));
}

TEST_P(WebPages, TimesHaveTheirZone) {
  const std::string html = web::timeOf(kToday_us).html();
  EXPECT_THAT(html, HasSubstr("datetime=\"2026-11-22T00:00:00Z\""));
  const std::string zone = QDateTime::fromMSecsSinceEpoch(kToday_us / 1000).timeZoneAbbreviation().toStdString();
  ASSERT_FALSE(zone.empty());
  EXPECT_THAT(html, HasSubstr(" " + zone + "</time>"));
}

TEST_P(WebPages, WordsOfTheFieldAreExplainedWhereTheyStand) {
  const WebSchool school(rig->open());
  const std::string admin = school.signIn("admin");
  EXPECT_THAT(school.get("/attempts/" + school.annas, admin).body,
              HasSubstr("proven<span class=\"quiet\">: the recording"));
  EXPECT_THAT(school.get("/audit", admin).body, HasSubstr("Action: what the user did or tried to do."));
  const Curriculum curriculum = valueOf(loadCurriculum("central_line"));
  const auto level =
      std::ranges::find_if(curriculum.levels, [](const Level& one) { return one.mastery.cusum.has_value(); });
  ASSERT_NE(level, curriculum.levels.end());
  EXPECT_THAT(school.get("/me?level=" + level->name, school.signIn("anna")).body,
              HasSubstr("LC-CUSUM is a score that rises with each pass"));
}

TEST_P(WebPages, APageOfTheLogWithoutEntriesSaysSo) {
  const WebSchool school(rig->open());
  EXPECT_THAT(school.get("/audit?before=1", school.signIn("admin")).body,
              AllOf(HasSubstr("There are no entries before number 1."), Not(HasSubstr("<table"))));
}

TEST_P(WebPages, AWorkstationGetsATokenOnceAndLosesItsAccess) {
  const WebSchool school(rig->open());
  const std::string admin = school.signIn("admin");
  EXPECT_THAT(school.get("/workstations", admin).body, HasSubstr("There are no workstations yet."));
  const std::string added = school.post("/workstations", {{"name", "<b>ward"}}, admin).body;
  const std::size_t at = added.find("class=\"token\">");
  ASSERT_NE(at, std::string::npos) << added;
  const std::string token = added.substr(at + std::string("class=\"token\">").size(), 64);
  EXPECT_EQ(valueOf(SiteService(school.store).workstationOf(token)), "<b>ward");
  const std::string list = school.get("/workstations", admin).body;
  EXPECT_THAT(list, AllOf(HasSubstr("&lt;b&gt;ward"), HasSubstr("in use"), Not(HasSubstr(token))));
  EXPECT_THAT(school.post("/workstations", {{"name", "<b>ward"}}, admin).body, HasSubstr("has a token already"));
  EXPECT_EQ(school.post("/workstations/revoke", {{"name", "<b>ward"}}, admin).status, 303);
  EXPECT_EQ(valueOf(SiteService(school.store).workstationOf(token)), std::nullopt);
  EXPECT_THAT(school.get("/workstations", admin).body, HasSubstr("revoked, "));
  for (const std::string name : {"anna", "ina"}) {
    EXPECT_THAT(school.post("/workstations", {{"name", "own"}}, school.signIn(name)).body,
                HasSubstr("do not have the permission"));
    EXPECT_THAT(school.post("/workstations/revoke", {{"name", "<b>ward"}}, school.signIn(name)).body,
                HasSubstr("do not have the permission"));
  }
}

TEST_P(WebPages, AnInstructorAcceptsAndVoidsAnAttempt) {
  const WebSchool school(rig->open());
  AttemptFacts facts = endedFacts(begunFacts());
  facts.curriculum.clear(), facts.level.clear(), facts.proof = AttemptProof::Unproven;
  valueOf(AttemptStore(school.as(school.anna)).add(facts));
  const std::string path = "/attempts/" + facts.id, ina = school.signIn("ina"), anna = school.signIn("anna");
  const auto stored = [&] { return valueOf(AttemptStore(school.admin).attempt(facts.id)); };
  EXPECT_THAT(school.get(path, anna).body, Not(HasSubstr("Does this attempt count?")));
  EXPECT_EQ(school.post(path + "/accept", {{"reason", "me"}}, anna).status, 400);
  EXPECT_EQ(school.post(path + "/void", {{"reason", "me"}}, anna).status, 400);
  EXPECT_EQ(school.post(path + "/void", {{"reason", "x"}}, school.signIn("otto")).status, 404);
  EXPECT_EQ(stored().facts.proof, AttemptProof::Unproven);
  EXPECT_THAT(school.post(path + "/accept", {{"reason", " "}}, ina).body, HasSubstr("for a reason"));
  EXPECT_EQ(school.post(path + "/accept", {{"reason", "I watched it"}}, ina).status, 303);
  EXPECT_EQ(stored().facts.proof, AttemptProof::Accepted);
  EXPECT_EQ(school.post(path + "/void", {{"reason", "device failed"}}, ina).status, 303);
  EXPECT_EQ(stored().voidReason, "device failed");
}

TEST_P(WebPages, AVoidedAttemptSaysWhy) {
  const WebSchool school(rig->open());
  succeed(AttemptStore(school.as(school.ina)).voidAttempt(school.annas, "the device lost its zero"));
  const std::string page = school.get("/attempts/" + school.annas, school.signIn("anna")).body;
  EXPECT_THAT(page, AllOf(HasSubstr("Voided"), HasSubstr("the device lost its zero")));
}

TEST_P(WebPages, AClassShowsItsMembersAndWhoHasNotBegun) {
  const WebSchool school(rig->open());
  const std::string page = school.get("/classes/" + school.spring.id, school.signIn("ina")).body;
  EXPECT_THAT(page, AllOf(HasSubstr("Dr anna"), HasSubstr("Dr ben"), Not(HasSubstr("Dr carl"))));
  const std::string attention = page.substr(0, page.find("<h2>Members"));
  EXPECT_THAT(attention, HasSubstr("Dr ben"));
  EXPECT_THAT(page, HasSubstr("/people/" + school.anna.id));
}

TEST_P(WebPages, PagesAreWellFormedAndNameTheirParts) {
  const WebSchool school(rig->open());
  const std::string admin = school.signIn("admin");
  for (const std::string& path :
       {std::string("/me"), std::string("/classes"), "/classes/" + school.spring.id,
        "/classes/" + school.spring.id + "/members", "/classes/" + school.spring.id + "/delete",
        "/classes/" + school.spring.id + "/import", std::string("/people"), "/people/" + school.anna.id,
        "/attempts/" + school.annas, std::string("/audit"), std::string("/password")}) {
    const std::string page = school.get(path, admin).body;
    for (const std::string part : {"<html lang=\"en\">", "<title>", "<main id=\"main\"", "href=\"#main\""})
      EXPECT_THAT(page, HasSubstr(part)) << path;
    for (const std::string tag : {"table", "section", "form", "ul", "figure", "svg", "details"}) {
      const auto count = [&](const std::string& what) {
        int found = 0;
        for (std::size_t at = page.find(what); at != std::string::npos; at = page.find(what, at + 1)) ++found;
        return found;
      };
      EXPECT_EQ(count("<" + tag + ">") + count("<" + tag + " "), count("</" + tag + ">")) << path << " " << tag;
    }
  }
}

TEST(WebCharts, ShowEachValueOnceInTheDrawingAndOnceInTheTable) {
  using Mark = web::AttemptChart::Mark;
  web::AttemptChart values{.title = "Points <at> A", .unit = "%"};
  values.points = {web::AttemptChart::Point{40, Mark::Failed}, std::nullopt,
                   web::AttemptChart::Point{80.5, Mark::Passed}};
  values.limit = 62, values.limitName = "limit 62";
  const std::string html = web::chart(values).html();
  EXPECT_THAT(html, AllOf(HasSubstr("Points &lt;at&gt; A"), HasSubstr("<circle"), HasSubstr("class=\"failed\""),
                          HasSubstr("<td>80.5</td><td>passed</td>"), HasSubstr("<td>no value</td>"),
                          HasSubstr("limit 62"), HasSubstr("Value, %")));
  EXPECT_THAT(web::chart({}).html(), HasSubstr("no values yet"));
}

TEST(WebCharts, PlaceValuesToScale) {
  web::AttemptChart values{.title = "x"};
  values.points = {web::AttemptChart::Point{0}, web::AttemptChart::Point{50}, web::AttemptChart::Point{100}};
  const std::string html = web::chart(values).html();
  const auto attribute = [&](std::size_t from, const std::string& name) {
    const std::size_t at = html.find(name + "=\"", from) + name.size() + 2;
    return std::stod(html.substr(at));
  };
  std::vector<double> x, y;
  for (std::size_t at = html.find("<circle"); at != std::string::npos; at = html.find("<circle", at + 1)) {
    x.push_back(attribute(at, "cx"));
    y.push_back(attribute(at, "cy"));
  }
  ASSERT_EQ(x.size(), 3U);
  EXPECT_NEAR(x[1], (x[0] + x[2]) / 2, 0.6);
  EXPECT_NEAR(y[1], (y[0] + y[2]) / 2, 0.6);
  EXPECT_LT(y[2], y[0]) << "more is higher";
}

TEST(WebHeat, ColorsKeepTheContrastOfText) {
  const auto luminance = [](const HeatColor& color) {
    const auto linear = [](int channel) {
      const double c = channel / 255.0;
      return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color[0]) + 0.7152 * linear(color[1]) + 0.0722 * linear(color[2]);
  };
  for (int share = 0; share <= 100; share += 10) {
    const HeatColor color = heatColorOf(share);
    const double ground = luminance(color), ink = needsBlackText(color) ? 0 : 1;
    EXPECT_GE((std::max(ground, ink) + 0.05) / (std::min(ground, ink) + 0.05), 4.5) << share << ": WCAG 2 AA";
  }
}

}  // namespace
}  // namespace insonate::test
