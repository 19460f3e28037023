#include "WebRig.h"
#include "page/Page.h"

#include <insonate/cases/CaseVersions.h>
#include <insonate/curriculum/Workstations.h>
#include <insonate/site/PublishedCases.h>

#include <support/SmallCase.h>
#include <support/TestData.h>

namespace insonate::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// The pages of curricula and cases, with a folder of cases.
class WebCurricula : public OnBoth {
 protected:
  WebSchool& school() {
    if (!school_) school_.emplace(rig->open(), web::WebOptions{.cases = cases.path()});
    return *school_;
  }
  void addCase(const std::string& folder, const std::string& title, const std::string& date = "2026-11-22") const {
    PatientCase neck = smallCase();
    neck.manifest.title = title;
    valueOf(saveCaseVersion(neck, cases / folder, date, ""));
    valueOf(publishCase(neck, cases / folder, date));
  }
  /// Another version of the curriculum of the classes, whose first level has this case.
  static std::string versionWith(const std::string& caseName, const std::string& title = "The first one") {
    Curriculum curriculum = valueOf(loadCurriculum("central_line"));
    ++curriculum.version;
    curriculum.levels.front().caseName = caseName, curriculum.levels.front().title = title;
    return curriculumText(curriculum);
  }
  web::Response send(const std::string& file, const std::string& secret) {
    web::Request made = WebSchool::request("POST", "/curricula", secret);
    made.form.emplace("code", web::formCode(secret));
    made.files["curriculum"] = file;
    made.headers["sec-fetch-site"] = "same-origin";
    return school().site.answer(made);
  }
  static std::string newest() {
    return "/curricula/central_line/" + std::to_string(valueOf(loadCurriculum("central_line")).version + 1);
  }

  const TemporaryFolder cases;

 private:
  std::optional<WebSchool> school_;
};
INSONATE_ON_BOTH(WebCurricula);

TEST_P(WebCurricula, AnInstructorPublishesAFile) {
  const std::string ina = school().signIn("ina"), text = versionWith("textbook", "<b>First</b>");
  const web::Response sent = send(text, ina);
  EXPECT_EQ(sent.status, 303) << sent.body;
  EXPECT_EQ(headerOf(sent, "Location"), newest());
  EXPECT_THAT(school().get(newest(), ina).body,
              AllOf(HasSubstr("&lt;b&gt;First&lt;/b&gt;"), Not(HasSubstr("<b>")), HasSubstr("Textbook neck")));
  EXPECT_EQ(school().get(newest() + "/file", ina).body, text);
  EXPECT_THAT(school().get("/curricula", ina).body, HasSubstr(newest()));
  EXPECT_EQ(send(text, ina).status, 303) << "a second click";
  EXPECT_THAT(send(versionWith("textbook", "Changed"), ina).body, HasSubstr("already published"));
}

TEST_P(WebCurricula, ALevelMayNameAPublishedCaseOfTheServer) {
  const std::string admin = school().signIn("admin");
  const web::Response refused = send(versionWith("Broad neck"), admin);
  EXPECT_EQ(refused.status, 422);
  EXPECT_THAT(refused.body, HasSubstr("Broad neck"));
  EXPECT_EQ(school().get(newest(), admin).status, 404);
  addCase("broad", "Broad neck");
  EXPECT_EQ(send(versionWith("Broad neck"), admin).status, 303);
}

TEST_P(WebCurricula, BuiltInCurriculaArePublishedByNameOnly) {
  const std::string admin = school().signIn("admin");
  EXPECT_EQ(school().post("/curricula", {{"preset", "central_line"}}, admin).status, 303);
  for (const std::string name : {"/etc/hostname", "../x", "no such", ""}) {
    const web::Response refused = school().post("/curricula", {{"preset", name}}, admin);
    EXPECT_EQ(refused.status, 422) << name;
    EXPECT_THAT(refused.body, HasSubstr("No curriculum was chosen")) << name;
  }
  EXPECT_EQ(send("no JSON", admin).status, 422);
}

TEST_P(WebCurricula, TraineesPublishNothing) {
  EXPECT_EQ(send(versionWith("textbook"), school().signIn("anna")).status, 403);
  EXPECT_EQ(school().get(newest(), school().signIn("ina")).status, 404);
}

TEST_P(WebCurricula, ThePageOfCasesSaysWhichCasesAreMissing) {
  const std::string ina = school().signIn("ina");
  EXPECT_THAT(school().get("/cases", ina).body,
              AllOf(HasSubstr("has no published case"), Not(HasSubstr("Missing cases"))));
  addCase("broad", "Broad neck", "2026-11-20");
  ASSERT_EQ(send(versionWith("Broad neck"), ina).status, 303);
  const auto version = valueOf(loadCurriculum("central_line")).version + 1;
  succeed(CohortStore(school().admin).setCurriculum(school().spring.id, "central_line", version));
  EXPECT_THAT(school().get("/cases", ina).body,
              AllOf(HasSubstr("Broad neck"), HasSubstr("The first one"), Not(HasSubstr("Missing cases"))));
  EXPECT_THAT(school().get("/cases", school().signIn("otto")).body, Not(HasSubstr("The first one")))
      << "another instructor's class";
  addCase("later", "Broad neck", "2026-11-21");
  EXPECT_THAT(school().get("/cases", ina).body, HasSubstr("another case has the same title"));
  std::filesystem::remove_all(cases / "broad"), std::filesystem::remove_all(cases / "later");
  EXPECT_THAT(school().get("/cases", ina).body, AllOf(HasSubstr("Missing cases"), HasSubstr("The first one")));
}

/// Tokens of workstations, which SiteService checks, too.
TEST_P(WebCurricula, CasesAreForWorkstationsWithATokenOnly) {
  addCase("broad", "Broad neck");
  const std::string token = valueOf(Workstations(school().admin).add("ward 7"));
  web::Request asking = WebSchool::request("POST", "/api/site/cases", "");
  EXPECT_EQ(school().site.answer(asking).status, 401);
  asking.headers["authorization"] = "Bearer " + token;
  const web::Response list = school().site.answer(asking);
  EXPECT_EQ(list.status, 200);
  EXPECT_THAT(list.body, HasSubstr("Broad neck"));
  const std::string id = PublishedCases(cases.path()).list()->front().id;
  asking.path = "/api/site/case-files/" + id + "/case.json/0";
  const web::Response part = school().site.answer(asking);
  EXPECT_EQ(part.file, cases / "broad/versions/001/case.json");
  EXPECT_EQ(part.fileSize, std::filesystem::file_size(part.file));
  asking.path = "/api/site/case-files/" + id + "/published.json/0";
  EXPECT_EQ(school().site.answer(asking).status, 422);
  succeed(Workstations(school().admin).revoke("ward 7"));
  EXPECT_EQ(school().site.answer(asking).status, 401);
}

}  // namespace
}  // namespace insonate::test
