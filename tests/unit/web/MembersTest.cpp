#include "WebRig.h"
#include "page/Page.h"

#include <insonate/curriculum/OpeningStore.h>

#include <algorithm>

namespace insonate::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class WebMembers : public OnBoth {
 protected:
  static std::string names(const SignedIn& by, const std::string& cohort) {
    std::string all;
    for (const Member& one : valueOf(CohortStore(by).members(cohort)))
      all += one.person.name + (one.teaches ? "* " : " ");
    return all;
  }
};
INSONATE_ON_BOTH(WebMembers);

TEST_P(WebMembers, AnAdministratorMakesAndRenamesAClass) {
  const WebSchool school(rig->open());
  const std::string admin = school.signIn("admin");
  EXPECT_EQ(school.post("/classes", {{"name", "Spring"}}, admin).status, 422);
  EXPECT_THAT(school.post("/classes", {{"name", "spring"}}, admin).body,
              AllOf(HasSubstr("There is a class named"), HasSubstr("value=\"spring\"")));
  const std::string page = headerOf(school.post("/classes", {{"name", "Winter"}}, admin), "Location");
  EXPECT_THAT(school.get(page, admin).body, AllOf(HasSubstr("Winter"), HasSubstr("no members yet")));
  const std::string address = page.substr(0, page.rfind('/'));
  EXPECT_EQ(school.post(address + "/name", {{"class-name", "Early winter"}}, admin).status, 303);
  EXPECT_THAT(school.post(address + "/name", {{"class-name", "Autumn"}}, admin).body,
              AllOf(HasSubstr("role=\"alert\""), HasSubstr("value=\"Autumn\"")));
  EXPECT_THAT(school.get("/classes", admin).body, HasSubstr("Early winter"));
}

TEST_P(WebMembers, MembersComeAndGo) {
  const WebSchool school(rig->open());
  const std::string admin = school.signIn("admin"), ina = school.signIn("ina");
  const std::string page = "/classes/" + school.spring.id + "/members";
  EXPECT_EQ(school.post(page, {{"person", " CARL "}, {"as", "trainee"}}, admin).status, 303);
  EXPECT_EQ(school.post(page, {{"person", "otto@example.org"}, {"as", "instructor"}}, admin).status, 303);
  EXPECT_EQ(names(school.admin, school.spring.id), "ina* otto* anna ben carl ");
  EXPECT_THAT(school.post(page, {{"person", "unknown.there"}, {"as", "trainee"}}, admin).body,
              HasSubstr("No account has the sign-in name or e-mail address &#39;unknown.there&#39;"));
  EXPECT_EQ(school.post(page, {{"person", ""}, {"as", "trainee"}}, admin).status, 422);
  EXPECT_THAT(school.post(page, {{"person", "ben"}, {"as", "instructor"}}, admin).body, HasSubstr("cannot teach"));
  EXPECT_EQ(school.post(page, {{"person", "carl"}, {"as", "trainee"}}, ina).status, 422)
      << "it would open his attempts to her";

  EXPECT_EQ(school.post(page + "/remove", {{"person", school.carl.id}}, ina).status, 303);
  EXPECT_EQ(school.post(page + "/remove", {{"person", school.otto.id}}, ina).status, 422) << "an instructor";
  EXPECT_EQ(school.post(page + "/remove", {{"person", school.otto.id}}, admin).status, 303);
  EXPECT_EQ(school.post(page + "/remove", {{"person", school.otto.id}}, admin).status, 422);
  EXPECT_EQ(names(school.admin, school.spring.id), "ina* anna ben ");
}

TEST_P(WebMembers, AnInstructorAddsATraineeToTheOwnClass) {
  const WebSchool school(rig->open());
  const std::string ina = school.signIn("ina"), page = "/classes/" + school.spring.id + "/members";
  const web::Fields dora{{"name", "dora"}, {"full-name", "Dr dora"}, {"email", ""}, {"password", ""}};
  const web::Response added = school.post(page + "/new", dora, ina);
  EXPECT_THAT(added.body, AllOf(HasSubstr("Password of Dr dora"), HasSubstr("<code class=\"token\">")));
  EXPECT_EQ(names(school.admin, school.spring.id), "ina* anna ben dora ");
  const web::Response again = school.post(page + "/new", dora, ina);
  EXPECT_EQ(again.status, 422);
  EXPECT_THAT(again.body, AllOf(HasSubstr("There is a person named"), HasSubstr("value=\"Dr dora\"")));
  EXPECT_THAT(school.get(page, ina).body,
              AllOf(Not(HasSubstr("who has an account")), Not(HasSubstr("Rename")), Not(HasSubstr("Archive")),
                    Not(HasSubstr("/delete")), HasSubstr("Set curriculum")));
}

TEST_P(WebMembers, TheCurriculumIsOneThatIsPublished) {
  const WebSchool school(rig->open());
  const std::string ina = school.signIn("ina"), address = "/classes/" + school.spring.id;
  valueOf(PublishedCurricula(school.admin).publish("central_line", 99, curriculumOf(99)));
  EXPECT_EQ(school.post(address + "/curriculum", {{"curriculum", "99 central_line"}}, ina).status, 303);
  EXPECT_EQ(valueOf(CohortStore(school.as(school.ina)).cohorts()).front().curriculumVersion, 99);
  EXPECT_THAT(school.get(address + "/members", ina).body,
              HasSubstr("<option value=\"99 central_line\" selected=\"\">central_line, version 99</option>"));
  for (const std::string chosen : {"", "x", "100 central_line", "99", "99 ", "99999999999 central_line"})
    EXPECT_EQ(school.post(address + "/curriculum", {{"curriculum", chosen}}, ina).status, 422) << chosen;
  EXPECT_EQ(valueOf(CohortStore(school.as(school.ina)).cohorts()).front().curriculumVersion, 99);
}

TEST_P(WebMembers, AnArchivedClassIsShownAndRestored) {
  const WebSchool school(rig->open());
  const std::string admin = school.signIn("admin"), ina = school.signIn("ina");
  const std::string address = "/classes/" + school.spring.id;
  EXPECT_EQ(school.post(address + "/archive", {{"state", "x"}}, admin).status, 422);
  EXPECT_EQ(school.post(address + "/archive", {{"state", "archived"}}, admin).status, 303);
  EXPECT_THAT(school.get("/classes", ina).body, HasSubstr("Spring (archived)"));
  EXPECT_THAT(school.get(address, ina).body, AllOf(HasSubstr("Spring (archived)"), HasSubstr("Dr anna")));
  EXPECT_THAT(school.get(address + "/members", ina).body,
              AllOf(HasSubstr("This class is archived"), HasSubstr("Dr anna"), Not(HasSubstr("Add trainee"))));
  const std::string members = school.get(address + "/members", admin).body;
  EXPECT_LT(members.find("This class is archived"), members.find("Dr anna")) << "where the browser shows the page";
  EXPECT_EQ(school.post(address + "/archive", {{"state", "active"}}, admin).status, 303);
  EXPECT_THAT(school.get(address + "/members", ina).body, HasSubstr("Add trainee"));
}

TEST_P(WebMembers, ADeletionSaysWhatIsLostAndAsksForTheName) {
  const WebSchool school(rig->open());
  const std::string admin = school.signIn("admin"), address = "/classes/" + school.spring.id;
  EXPECT_THAT(
      school.get(address + "/delete", admin).body,
      AllOf(HasSubstr("2 trainees and 1 instructor."), HasSubstr("0 openings of its tests"), HasSubstr("What stays")));
  const web::Response wrong = school.post(address + "/delete", {{"class-name", "Autumn"}}, admin);
  EXPECT_EQ(wrong.status, 422);
  EXPECT_THAT(wrong.body, HasSubstr("is not the name of this class"));
  EXPECT_EQ(school.get(address, admin).status, 200);
  EXPECT_EQ(headerOf(school.post(address + "/delete", {{"class-name", "Spring"}}, admin), "Location"),
            "/classes?deleted=1");
  EXPECT_THAT(school.get("/classes", admin).body, Not(HasSubstr("was deleted")));
  web::Request deleted = WebSchool::request("GET", "/classes", admin);
  deleted.query["deleted"] = "1";
  EXPECT_THAT(school.site.answer(deleted).body, HasSubstr("The class was deleted."));
  succeed(CohortStore(school.admin).remove(school.autumn.id, "Autumn"));
  EXPECT_THAT(school.get("/classes", admin).body,
              AllOf(HasSubstr("Add a class below"), Not(HasSubstr("An administrator adds classes"))));
  EXPECT_EQ(school.get(address, admin).status, 404);
  EXPECT_EQ(school.get("/attempts/" + school.annas, school.signIn("anna")).status, 200);
}

TEST_P(WebMembers, OthersChangeNoClass) {
  const WebSchool school(rig->open());
  const std::string address = "/classes/" + school.spring.id;
  const std::vector<std::pair<std::string, web::Fields>> ofAdministrators{
      {"/classes", {{"name", "Winter"}}},
      {address + "/name", {{"class-name", "Mine"}}},
      {address + "/archive", {{"state", "archived"}}},
      {address + "/delete", {{"class-name", "Spring"}}},
      {address + "/members", {{"person", "carl"}, {"as", "trainee"}}}};
  const std::vector<std::pair<std::string, web::Fields>> ofInstructors{
      {address + "/members/new", {{"name", "dora"}, {"full-name", "D"}, {"email", ""}, {"password", ""}}},
      {address + "/members/remove", {{"person", school.ben.id}}},
      {address + "/curriculum", {{"curriculum", "1 central_line"}}}};
  for (const std::string who : {"anna", "carl", "ina", "otto"}) {
    const std::string secret = school.signIn(who);
    auto forms = ofAdministrators;
    if (who != "ina") forms.insert(forms.end(), ofInstructors.begin(), ofInstructors.end());
    for (const auto& [path, form] : forms) {
      const int status = school.post(path, form, secret).status;
      EXPECT_TRUE(status == 403 || status == 404 || status == 422) << who << " " << path << " " << status;
    }
  }
  const auto cohorts = valueOf(CohortStore(school.admin).cohorts());
  ASSERT_EQ(cohorts.size(), 2U);
  EXPECT_EQ(cohorts.back().name, "Spring");
  EXPECT_FALSE(cohorts.back().archived);
  EXPECT_EQ(names(school.admin, school.spring.id), "ina* anna ben ");
}

}  // namespace
}  // namespace insonate::test
