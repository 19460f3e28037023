#include "WebRig.h"

#include <insonate/curriculum/Csv.h>
#include <insonate/teaching/ClassExports.h>

#include <nlohmann/json.hpp>

#include <map>

namespace insonate::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::string kHome = "?home=https%3A%2F%2Ftraining.example.org";

class WebExports : public OnBoth {};
INSONATE_ON_BOTH(WebExports);

TEST_P(WebExports, HaveTheFilesOfTheCommandLine) {
  const WebSchool school(rig->open());
  const std::string ina = school.signIn("ina"), address = "/classes/" + school.spring.id + "/export/";
  const SignedIn by = school.as(school.ina);
  const Curriculum curriculum = valueOf(loadCurriculum("central_line"));
  const web::Response attempts = school.get(address + "attempts.csv", ina);
  EXPECT_EQ(attempts.type, "text/csv; charset=utf-8");
  EXPECT_EQ(headerOf(attempts, "Content-Disposition"), "attachment; filename=\"attempts.csv\"");
  EXPECT_EQ(headerOf(attempts, "Cache-Control"), "no-store");
  EXPECT_EQ(attempts.body, valueOf(exportAttempts(by, school.spring, &curriculum)).csv);
  const auto rows = valueOf(parseCsv(attempts.body));
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[1].fields[0], school.annas);
  EXPECT_EQ(rows[1].fields[2], "Dr anna");

  EXPECT_EQ(school.get(address + "grades.csv?by=name", ina).body,
            valueOf(exportGrades(by, school.spring, curriculum, "Insonate", GradeKey::Name)).book.csv);
  const std::string byMail = school.get(address + "grades.csv", ina).body;
  EXPECT_THAT(byMail, HasSubstr("anna@example.org"));
  EXPECT_THAT(byMail, Not(HasSubstr("ben@example.org"))) << "no attempts, no grade";

  const auto statements = nlohmann::json::parse(school.get(address + "statements.json" + kHome, ina).body);
  ASSERT_EQ(statements.size(), 1U);
  EXPECT_EQ(statements[0]["actor"]["account"]["homePage"], "https://training.example.org");
  EXPECT_EQ(school.get(address + "statements.json?home=nowhere", ina).status, 400);
}

TEST_P(WebExports, AreForThoseWhoTeachTheClass) {
  const WebSchool school(rig->open());
  for (const auto& [who, status] : std::map<std::string, int>{
           {"anna", 403}, {"ben", 403}, {"carl", 404}, {"otto", 404}, {"ina", 200}, {"admin", 200}}) {
    const std::string secret = school.signIn(who);
    for (const std::string& file :
         {std::string("attempts.csv"), std::string("grades.csv"), "statements.json" + kHome}) {
      const web::Response response = school.get("/classes/" + school.spring.id + "/export/" + file, secret);
      EXPECT_EQ(response.status, status) << who << " " << file;
      if (status != 200 && who != "anna") {
        EXPECT_THAT(response.body, Not(HasSubstr("Dr anna"))) << who;
      }
    }
  }
  EXPECT_EQ(school.get("/classes/" + school.spring.id + "/export/attempts.csv").status, 303);
}

TEST_P(WebExports, AClassWithoutACurriculumHasAttemptsOnly) {
  const WebSchool school(rig->open());
  const Cohort summer = valueOf(CohortStore(school.admin).add("Summer"));
  const std::string admin = school.signIn("admin"), address = "/classes/" + summer.id;
  EXPECT_EQ(school.get(address + "/export/attempts.csv", admin).status, 200);
  EXPECT_EQ(school.get(address + "/export/grades.csv", admin).status, 404);
  const std::string page = school.get(address, admin).body;
  EXPECT_THAT(page, HasSubstr("attempts.csv"));
  EXPECT_THAT(page, Not(HasSubstr("grades.csv")));
}

}  // namespace
}  // namespace insonate::test
