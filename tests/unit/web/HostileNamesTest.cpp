#include "RouteTable.h"

#include <insonate/curriculum/CommentStore.h>
#include <insonate/curriculum/OpeningStore.h>
#include <insonate/curriculum/Workstations.h>

namespace insonate::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kHostile = "\"><script>alert(1)</script><img src=x onerror='y'>";

/// A school in which each name, title, comment and reason is hostile.
class WebHostileNames : public OnBoth {
 protected:
  void SetUp() override {
    OnBoth::SetUp();
    if (IsSkipped()) return;
    school.emplace(rig->open());
    publishCurriculum();
    for (const Person& person :
         {school->anna, school->ben, school->carl, school->ina, school->otto, school->admin.person()}) {
      Person renamed = person;
      renamed.fullName = kHostile;
      succeed(PeopleStore(school->admin).change(renamed));
    }
    succeed(CohortStore(school->admin).rename(school->spring.id, kHostile));
    succeed(CohortStore(school->admin).rename(school->autumn.id, kHostile + "autumn"));
    const SignedIn ina = school->as(school->ina);
    valueOf(CommentStore(ina).add(school->annas, 0, kHostile));
    valueOf(CommentStore(ina).add(attempt, 0, kHostile));
    succeed(AttemptStore(ina).voidAttempt(school->annas, kHostile));
    valueOf(OpeningStore(ina).open({.cohort = school->spring.id, .level = "jugular_test", .code = "venus"}));
    valueOf(Workstations(school->admin).add(kHostile));
    for (const std::string name : {"anna", "ina"}) {
      web::Fields answers{{"id", freshUuid()}};
      for (const char* question : {"went_well", "happened", "next"})
        answers.emplace("answer-" + std::string(question), kHostile);
      EXPECT_EQ(school->post("/attempts/" + attempt + "/forms/debrief", answers, school->signIn(name)).status, 303);
    }
  }

  /// A curriculum of the class Spring with hostile titles, and an attempt of Anna at its first level.
  void publishCurriculum() {
    Curriculum curriculum = valueOf(loadCurriculum("central_line"));
    ++curriculum.version;
    curriculum.title = curriculum.about = kHostile;
    for (Level& level : curriculum.levels) level.title = level.about = kHostile;
    valueOf(PublishedCurricula(school->admin).publish(curriculum.name, curriculum.version, curriculumText(curriculum)));
    succeed(CohortStore(school->admin).setCurriculum(school->spring.id, curriculum.name, curriculum.version));
    AttemptFacts facts = begunFacts();
    facts.curriculumVersion = version = curriculum.version;
    facts.level = curriculum.levels.front().name, facts.procedure = curriculum.levels.front().procedure;
    attempt = keepAttempt(school->as(school->anna), facts).id;
  }

  static bool isHtml(const web::Response& response) { return response.type.starts_with("text/html"); }

  /// The only scripts of a page are the files of this server.
  static void expectClean(std::string page) {
    for (const std::string file : {"live", "video"}) {
      const std::string script = "<script src=\"/" + file + ".js\" defer=\"\">";
      if (const auto at = page.find(script); at != std::string::npos) page.erase(at, script.size());
    }
    EXPECT_THAT(page, AllOf(Not(HasSubstr("<script")), Not(HasSubstr("<img")), Not(HasSubstr("onerror='"))));
  }

  std::optional<WebSchool> school;
  int version = 0;
  std::string attempt;
};
INSONATE_ON_BOTH(WebHostileNames);

TEST_P(WebHostileNames, StayTextOnEachPage) {
  std::vector<std::string> paths{"/attempts/" + attempt, "/attempts/" + attempt + "/forms/debrief",
                                 "/curricula/central_line/" + std::to_string(version), "/people/" + school->ina.id};
  for (const RouteLine& line : routeTable(*school))
    if (line.method == "GET") paths.push_back(line.path);
  std::string query;
  for (const char* name :
       {"level", "metric", "class", "search", "role", "state", "with", "form", "next", "by", "before"})
    query += "&" + std::string(name) + "=" + web::encoded(kHostile);
  int shown = 0;
  for (const std::string name : {"anna", "ina", "admin"}) {
    const std::string secret = school->signIn(name);
    for (const std::string& path : paths)
      for (const std::string& asked : {path, path + (path.find('?') == std::string::npos ? "?" : "") + query}) {
        SCOPED_TRACE(name + " " + asked);
        const web::Response response = school->get(asked, secret);
        if (!isHtml(response) || response.status == 303) continue;
        expectClean(response.body);
        if (response.status != 200) continue;
        EXPECT_THAT(response.body, HasSubstr("&lt;script&gt;alert(1)")) << "the name of the user";
        ++shown;
      }
  }
  EXPECT_GT(shown, 100) << "few pages were opened";
}

TEST_P(WebHostileNames, StayTextInTheAnswerToEachForm) {
  std::map<std::string, std::string> secrets;
  for (const std::string name : {"anna", "ina", "admin"}) secrets[name] = school->signIn(name);
  int shown = 0;
  for (const RouteLine& line : routeTable(*school)) {
    if (line.method != "POST") continue;
    for (const auto& [field, usual] : line.form)
      for (const auto& [name, secret] : secrets) {
        SCOPED_TRACE(name + " " + line.path + " " + field);
        FreshTargets targets(*school);
        const std::string path = targets.filledIn(line.path);
        web::Fields form = targets.filledIn(line.form);
        form[field] = kHostile;
        const web::Response response = school->post(path, form, secret);
        if (!isHtml(response) || response.status == 303) continue;
        expectClean(response.body);
        ++shown;
      }
  }
  EXPECT_GT(shown, 50) << "few answers were pages";
}

}  // namespace
}  // namespace insonate::test
