#include "WebRig.h"

#include <insonate/curriculum/FormStore.h>

#include <filesystem>
#include <fstream>
#include <map>

namespace insonate::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;

class WebForms : public OnBoth {
 protected:
  /// A checklist with all answers, as a browser sends it.
  web::Fields checklist(const std::string& id) const {
    web::Fields fields{{"id", id}};
    for (const FormSection& section : valueOf(loadForm("jugular_checklist")).sections)
      for (const FormItem& item : section.items) fields.emplace("answer-" + item.name, "done");
    return fields;
  }
  web::Fields debrief(const std::string& next) const {
    return {{"id", freshUuid()}, {"answer-went_well", "The view"}, {"answer-happened", "A"}, {"answer-next", next}};
  }
};
INSONATE_ON_BOTH(WebForms);

TEST_P(WebForms, AChecklistIsHandedInOnceBesideTheAttempt) {
  const WebSchool school(rig->open());
  const std::string ina = school.signIn("ina"), attempt = "/attempts/" + school.annas;
  const std::string address = attempt + "/forms/jugular_checklist?class=" + school.spring.id;
  EXPECT_THAT(school.get(attempt + "?class=" + school.spring.id, ina).body, HasSubstr(address));
  EXPECT_THAT(school.get(address, ina).body, AllOf(HasSubstr("Dr anna"), HasSubstr("answer-asepsis")));

  web::Fields fields = checklist(freshUuid());
  fields.erase("answer-asepsis");
  fields.emplace("note-consent", "said <aloud>");
  const web::Response missing = school.post(address, fields, ina);
  EXPECT_EQ(missing.status, 400);
  EXPECT_THAT(missing.body, AllOf(HasSubstr("role=\"alert\""), HasSubstr("value=\"said &lt;aloud&gt;\""),
                                  HasSubstr("value=\"" + fields.find("id")->second + "\"")))
      << "nothing that was typed is lost";
  EXPECT_THAT(valueOf(FormStore(school.admin).listByAttempt(school.annas)), SizeIs(0));

  fields.emplace("answer-asepsis", "not_done");
  EXPECT_EQ(headerOf(school.post(address, fields, ina), "Location"), attempt + "?class=" + school.spring.id);
  EXPECT_EQ(school.post(address, fields, ina).status, 303) << "a double click";
  EXPECT_THAT(valueOf(FormStore(school.admin).listByAttempt(school.annas)), SizeIs(1));
  fields.erase("id"), fields.emplace("id", freshUuid());
  EXPECT_THAT(school.post(address, fields, ina).body, HasSubstr("can be handed in only once"));
  EXPECT_THAT(school.get(attempt, ina).body,
              AllOf(HasSubstr("Dr ina"), HasSubstr("said &lt;aloud&gt;"), HasSubstr("95 % (21 of 22 points)"),
                    Not(HasSubstr("/forms/jugular_checklist"))));
}

TEST_P(WebForms, ARaterReadsTheAnswersOfOthersAfterTheirOwn) {
  const WebSchool school(rig->open());
  const std::string attempt = "/attempts/" + school.annas, address = attempt + "/forms/jugular_checklist";
  web::Fields fields = checklist(freshUuid());
  fields.emplace("note-consent", "a remark");
  ASSERT_EQ(school.post(address, fields, school.signIn("ina")).status, 303);
  const std::string admin = school.signIn("admin");
  EXPECT_THAT(school.get(attempt, admin).body, AllOf(HasSubstr("after you have handed in the same form"),
                                                     Not(HasSubstr("a remark")), Not(HasSubstr(" points)"))));
  EXPECT_THAT(school.get(attempt, school.signIn("anna")).body, HasSubstr("a remark")) << "Anna may read it";
  ASSERT_EQ(school.post(address, checklist(freshUuid()), admin).status, 303);
  EXPECT_THAT(school.get(attempt, admin).body, HasSubstr("a remark"));
}

TEST_P(WebForms, BothSidesFillInADebriefAndTheNextBriefingRepeatsIt) {
  const WebSchool school(rig->open());
  const std::string anna = school.signIn("anna"), ina = school.signIn("ina"), attempt = "/attempts/" + school.annas;
  const std::string level = valueOf(loadCurriculum("central_line")).levels.front().name;
  const std::string briefing = "/classes/" + school.spring.id + "/levels/" + level;
  EXPECT_THAT(school.get("/me", anna).body, HasSubstr(briefing));
  EXPECT_THAT(school.get(briefing, anna).body, AllOf(HasSubstr("Steps"), HasSubstr("Passing and mastering this level"),
                                                     Not(HasSubstr("do differently this time"))));
  const std::string words = "<script>alert(1)</script> Slower & flatter";
  EXPECT_EQ(school.post(attempt + "/forms/debrief", debrief(words), anna).status, 303);
  EXPECT_EQ(school.post(attempt + "/forms/debrief", debrief("Center the vein first"), ina).status, 303);
  for (const std::string& page : {school.get(attempt, ina).body, school.get(briefing, anna).body})
    EXPECT_THAT(page, AllOf(HasSubstr("&lt;script&gt;alert(1)&lt;/script&gt; Slower &amp; flatter"),
                            HasSubstr("Center the vein first"), Not(HasSubstr("<script>alert"))));
  EXPECT_THAT(school.get(briefing, ina).body, Not(HasSubstr("Slower"))) << "Ina has no attempts at this level";
  EXPECT_THAT(school.get(briefing, school.signIn("ben")).body, Not(HasSubstr("Slower")));
  EXPECT_EQ(school.get("/classes/" + school.spring.id + "/levels/unknown", anna).status, 404);
}

TEST_P(WebForms, EachRoleFillsInWhatTheDatabaseAllows) {
  const WebSchool school(rig->open());
  const std::string forms = "/attempts/" + school.annas + "/forms/";
  for (const auto& [who, statuses] : std::map<std::string, std::pair<int, int>>{{"anna", {403, 303}},
                                                                                {"ben", {404, 404}},
                                                                                {"carl", {404, 404}},
                                                                                {"otto", {404, 404}},
                                                                                {"ina", {303, 303}},
                                                                                {"admin", {303, 303}}}) {
    const std::string secret = school.signIn(who);
    EXPECT_EQ(school.post(forms + "jugular_checklist", checklist(freshUuid()), secret).status, statuses.first) << who;
    EXPECT_EQ(school.post(forms + "debrief", debrief(who), secret).status, statuses.second) << who;
  }
  EXPECT_EQ(school.post(forms + "debrief", debrief("guest")).status, 403);
  EXPECT_THAT(valueOf(FormStore(school.admin).listByAttempt(school.annas)), SizeIs(5));
  web::Request forged = WebSchool::request("POST", forms + "debrief", school.signIn("otto"));
  forged.form = debrief("forged");
  EXPECT_EQ(school.site.answer(forged).status, 403) << "without the code of the form";
}

TEST_P(WebForms, NamesOfFilesAndStrangeAnswersAreRefused) {
  const WebSchool school(rig->open());
  const std::string ina = school.signIn("ina"), anna = school.signIn("anna"), attempt = "/attempts/" + school.annas;
  const std::filesystem::path form = rig->folder / "form.json";
  std::ofstream(form) << R"({"name": "f", "title": "F", "about": "A.", "source": "S.", "version": 1,
    "purpose": "debrief", "sections": [{"title": "T", "items": [{"name": "i", "title": "I", "kind": "text"}]}]})";
  ASSERT_TRUE(loadForm(form.string())) << "the name of a file loads a form elsewhere";
  for (const std::string& name : {web::encoded(form.string()), std::string("..%2Fdebrief"), std::string("nothing"),
                                  std::string("simulator_questionnaire")})
    EXPECT_EQ(school.get(attempt + "/forms/" + name, ina).status, 404) << name;
  for (const std::string& name : {web::encoded(form.string()), std::string("debrief"), std::string("nothing")}) {
    EXPECT_EQ(school.get("/me/forms/" + name, anna).status, 404) << name;
    EXPECT_EQ(school.post("/me/forms/" + name, debrief("next"), anna).status, 404) << name;
  }
  web::Fields strange = checklist(freshUuid());
  strange.erase("answer-consent"), strange.emplace("answer-consent", "perhaps");
  EXPECT_EQ(school.post(attempt + "/forms/jugular_checklist", strange, ina).status, 400);
  EXPECT_THAT(school.post(attempt + "/forms/jugular_checklist", checklist("1; DROP TABLE forms"), ina).body,
              HasSubstr("is not a UUID"));
  EXPECT_EQ(school.post(attempt + "/forms/debrief", debrief(std::string(100'000, 'x')), ina).status, 400);
  EXPECT_THAT(valueOf(FormStore(school.admin).listByAttempt(school.annas)), SizeIs(0));
}

TEST_P(WebForms, AQuestionnaireRefusesWhatIsNoNumberAndKeepsIt) {
  const WebSchool school(rig->open());
  const std::string anna = school.signIn("anna"), address = "/me/forms/simulator_questionnaire";
  EXPECT_THAT(school.get("/me", anna).body, HasSubstr(address));
  const auto answers = [](const std::string& years) {
    return web::Fields{{"id", freshUuid()}, {"answer-years_since_residency", years}, {"answer-secret", "x"}};
  };
  for (const std::string years : {"many", "61", "-1", "nan", "1e999"}) {
    const web::Response refused = school.post(address, answers(years), anna);
    EXPECT_EQ(refused.status, 400) << years;
    EXPECT_THAT(refused.body, HasSubstr("role=\"alert\"")) << years;
  }
  EXPECT_EQ(headerOf(school.post(address, answers(" 2.5 "), anna), "Location"), "/me");
  const auto kept = valueOf(FormStore(school.as(school.anna)).listByPerson(school.anna.id));
  ASSERT_THAT(kept, SizeIs(1));
  EXPECT_EQ(valueOf(parseAnswers(kept[0].filled.answers)), (FormAnswers{{"years_since_residency", 2.5}}))
      << "a field that is no question is not stored";
  EXPECT_THAT(school.get("/me", anna).body, HasSubstr("Handed in"));
}

}  // namespace
}  // namespace insonate::test
