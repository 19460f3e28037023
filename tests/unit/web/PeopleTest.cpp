#include "WebRig.h"
#include "page/Page.h"

#include <insonate/curriculum/AuditLog.h>

#include <algorithm>

namespace insonate::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class WebPeople : public OnBoth {};
INSONATE_ON_BOTH(WebPeople);

/// The password that a page shows in its only element "code".
std::string shownPassword(const web::Response& response) {
  const std::string begin = "<code class=\"token\">";
  const std::size_t at = response.body.find(begin);
  if (at == std::string::npos) return {};
  const std::size_t from = at + begin.size();
  return response.body.substr(from, response.body.find('<', from) - from);
}

Person personNamed(const WebSchool& school, const std::string& name) {
  const auto people = valueOf(PeopleStore(school.admin).all());
  const auto found = std::ranges::find(people, name, &Person::name);
  return found == people.end() ? Person{} : *found;
}

web::Fields newPerson(const std::string& name, const std::string& role, const std::string& cohort,
                      const std::string& password) {
  return {{"name", name}, {"full-name", "Dr " + name}, {"email", ""},
          {"role", role}, {"class", cohort},           {"password", password}};
}

TEST_P(WebPeople, AnAdministratorAddsAPersonWhosePasswordIsShownOnce) {
  const WebSchool school(rig->open());
  const std::string admin = school.signIn("admin");
  const web::Response added = school.post("/people", newPerson("dora", "trainee", school.spring.id, ""), admin);
  EXPECT_EQ(added.status, 200);
  const std::string password = shownPassword(added);
  EXPECT_EQ(password.size(), 14U);
  const Person dora = personNamed(school, "dora");
  EXPECT_EQ(dora.fullName, "Dr dora");
  for (const std::string& path : {std::string("/people"), "/people/" + dora.id, std::string("/audit")})
    EXPECT_THAT(school.get(path, admin).body, Not(HasSubstr(password))) << path;
  const std::string session = school.signIn("dora", password);
  EXPECT_EQ(headerOf(school.get("/me", session), "Location"), "/password") << "another password is needed";
  EXPECT_EQ(valueOf(CohortStore(school.admin).listByPerson(dora.id)).front().cohort.name, "Spring");

  const web::Response typed = school.post("/people", newPerson("emil", "instructor", "", "chosen password"), admin);
  EXPECT_EQ(headerOf(typed, "Location"), "/people/" + personNamed(school, "emil").id);
  EXPECT_EQ(personNamed(school, "emil").role, Role::Instructor);
  EXPECT_TRUE(valueOf(rig->open().signIn("emil", "chosen password")).mustChangePassword());
}

TEST_P(WebPeople, ARefusedPersonKeepsWhatWasTypedAndSaysWhy) {
  const WebSchool school(rig->open());
  const std::string admin = school.signIn("admin");
  const auto refused = [&](const web::Fields& form) {
    const web::Response response = school.post("/people", form, admin);
    EXPECT_EQ(response.status, 422);
    EXPECT_THAT(response.body, HasSubstr("role=\"alert\""));
    return response.body;
  };
  EXPECT_THAT(refused(newPerson("ANNA", "trainee", "", "")),
              AllOf(HasSubstr("There is a person named &#39;ANNA&#39; already"), HasSubstr("value=\"Dr ANNA\"")));
  EXPECT_THAT(refused(newPerson("fritz", "trainee", "", "short")), HasSubstr("8 to 200"));
  EXPECT_THAT(refused(newPerson("a b", "trainee", "", "")), HasSubstr("role=\"alert\""));
  EXPECT_THAT(refused(newPerson("fritz", "trainee", "no such class", "")), HasSubstr("There is no such class"));
  EXPECT_THAT(refused(newPerson("fritz", "king", "", "")), HasSubstr("Choose a role."));
  EXPECT_EQ(valueOf(PeopleStore(school.admin).all()).size(), 6U) << "nothing half made";
}

TEST_P(WebPeople, TheListIsSearchedAndFiltered) {
  const WebSchool school(rig->open());
  const std::string admin = school.signIn("admin");
  Person ben = school.ben;
  ben.fullName = "Ben J\xC3\xA4ger", ben.disabled = true;
  succeed(PeopleStore(school.admin).change(ben));
  const auto names = [&](const std::string& query) {
    const std::string body = school.get("/people?" + query, admin).body;
    std::string found;
    for (const std::string name : {"admin", "anna", "ben", "carl", "ina", "otto"})
      if (body.find("<td>" + name + "</td>") != std::string::npos) found += name + " ";
    return found;
  };
  EXPECT_EQ(names(""), "admin anna ben carl ina otto ");
  EXPECT_EQ(names("role=instructor"), "ina otto ");
  EXPECT_EQ(names("class=" + school.spring.id), "anna ben ina ");
  EXPECT_EQ(names("class=" + school.spring.id + "&role=trainee&state=active"), "anna ");
  EXPECT_EQ(names("state=disabled"), "ben ");
  EXPECT_EQ(names("search=j%C3%84GER%20ben"), "ben ");
  EXPECT_EQ(names("search=carl@example.org"), "carl ");
  EXPECT_EQ(names("search=nowhere"), "");
  EXPECT_THAT(school.get("/people?search=nowhere", admin).body, HasSubstr("No person matches the search."));
}

TEST_P(WebPeople, AnAdministratorChangesAnAccountByTheRulesOfTheDatabase) {
  const WebSchool school(rig->open());
  const std::string admin = school.signIn("admin"), page = "/people/" + school.anna.id;
  const web::Fields form{
      {"name", "anna2"}, {"full-name", "Anna Two"}, {"email", "a2@example.org"}, {"role", "instructor"}};
  EXPECT_EQ(headerOf(school.post(page, form, admin), "Location"), page);
  const Person changed = valueOf(PeopleStore(school.admin).person(school.anna.id));
  EXPECT_EQ(changed, (Person{school.anna.id, "anna2", "Anna Two", "a2@example.org", Role::Instructor, false}));
  const web::Response taken =
      school.post(page, {{"name", "ben"}, {"full-name", "Kept text"}, {"email", ""}, {"role", "trainee"}}, admin);
  EXPECT_EQ(taken.status, 422);
  EXPECT_THAT(taken.body, AllOf(HasSubstr("There is a person named"), HasSubstr("value=\"Kept text\"")));
  const std::string own = "/people/" + school.admin.person().id;
  EXPECT_THAT(school.post(own, {{"name", "admin"}, {"full-name", "A"}, {"email", ""}, {"role", "trainee"}}, admin).body,
              HasSubstr("is the last administrator"));
  EXPECT_THAT(school.post(own + "/state", {{"state", "disabled"}}, admin).body, HasSubstr("is the last administrator"));
  EXPECT_EQ(school.get("/people/" + freshUuid(), admin).status, 404);
  const auto entries = valueOf(AuditLog(school.admin).page(20, 0, school.anna.id));
  EXPECT_TRUE(std::ranges::any_of(entries, [](const AuditEntry& one) { return one.act == "change person"; }));
}

TEST_P(WebPeople, ADisabledAccountIsSignedOutUntilItIsEnabled) {
  const WebSchool school(rig->open());
  const std::string admin = school.signIn("admin"), anna = school.signIn("anna"), page = "/people/" + school.anna.id;
  EXPECT_EQ(school.post(page + "/state", {{"state", "gone"}}, admin).status, 422);
  EXPECT_EQ(school.post(page + "/state", {{"state", "disabled"}}, admin).status, 303);
  EXPECT_EQ(school.get("/me", anna).status, 303) << "the session has ended";
  EXPECT_THAT(school.get(page, admin).body, HasSubstr("Enable account"));
  EXPECT_EQ(school.post(page + "/state", {{"state", "active"}}, admin).status, 303);
  EXPECT_EQ(school.get("/me", school.signIn("anna")).status, 200);
}

TEST_P(WebPeople, PasswordsAreSetByAdministratorsAndByInstructorsForTheirTrainees) {
  const WebSchool school(rig->open());
  const std::string page = "/people/" + school.anna.id + "/password";
  for (const auto& [who, status] : std::map<std::string, int>{{"anna", 422}, {"ben", 403}, {"otto", 403}})
    EXPECT_EQ(school.post(page, {{"password", "another password"}}, school.signIn(who)).status, status) << who;
  EXPECT_TRUE(rig->open().signIn("anna", kPassword)) << "the password is as it was";
  const web::Response shown = school.post(page, {{"password", ""}}, school.signIn("ina"));
  EXPECT_TRUE(valueOf(rig->open().signIn("anna", shownPassword(shown))).mustChangePassword());
  const std::string admin = school.signIn("admin");
  EXPECT_EQ(school.post(page, {{"password", "short"}}, admin).status, 422);
  EXPECT_EQ(school.post(page, {{"password", "chosen password"}}, admin).status, 303);
  EXPECT_TRUE(rig->open().signIn("anna", "chosen password"));
  EXPECT_EQ(school.post("/people/" + school.admin.person().id + "/password", {}, admin).status, 422)
      << "the own password is changed with the old one";
}

TEST_P(WebPeople, AnAdministratorAddsAPersonToClassesAndRemovesIt) {
  const WebSchool school(rig->open());
  const std::string admin = school.signIn("admin"), page = "/people/" + school.carl.id;
  EXPECT_EQ(school.post(page + "/classes", {{"class", school.spring.id}, {"as", "trainee"}}, admin).status, 303);
  EXPECT_THAT(school.get(page, admin).body, AllOf(HasSubstr("Spring"), HasSubstr("Autumn")));
  EXPECT_THAT(school.post(page + "/classes", {{"class", school.spring.id}, {"as", "instructor"}}, admin).body,
              HasSubstr("cannot teach"));
  EXPECT_EQ(school.post(page + "/classes/leave", {{"class", school.autumn.id}}, admin).status, 303);
  const auto left = valueOf(CohortStore(school.admin).listByPerson(school.carl.id));
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left.front().cohort.name, "Spring");
}

TEST_P(WebPeople, OthersChangeNothing) {
  const WebSchool school(rig->open());
  const std::string page = "/people/" + school.anna.id;
  const std::vector<std::pair<std::string, web::Fields>> forms{
      {"/people", newPerson("dora", "trainee", "", "")},
      {page, {{"name", "x"}, {"full-name", "x"}, {"email", ""}, {"role", "administrator"}}},
      {page + "/state", {{"state", "disabled"}}},
      {page + "/classes", {{"class", school.autumn.id}, {"as", "trainee"}}}};
  for (const std::string who : {"anna", "ben", "carl", "ina", "otto"}) {
    const std::string secret = school.signIn(who);
    for (const auto& [path, form] : forms) {
      const int status = school.post(path, form, secret).status;
      EXPECT_TRUE(status == 403 || status == 422) << who << " " << path << " " << status;
    }
  }
  EXPECT_EQ(school.post("/people", newPerson("dora", "trainee", "", "")).status, 403) << "nobody is signed in";
  EXPECT_EQ(valueOf(PeopleStore(school.admin).person(school.anna.id)), school.anna);
  EXPECT_EQ(valueOf(PeopleStore(school.admin).all()).size(), 6U);
  EXPECT_EQ(valueOf(CohortStore(school.admin).listByPerson(school.anna.id)).size(), 1U);
  EXPECT_THAT(school.get(page, school.signIn("ina")).body,
              AllOf(HasSubstr("Set password"), Not(HasSubstr("Disable account")), Not(HasSubstr("Save"))));
  EXPECT_THAT(school.get(page, school.signIn("anna")).body, Not(HasSubstr("Set password")));
}

}  // namespace
}  // namespace insonate::test
