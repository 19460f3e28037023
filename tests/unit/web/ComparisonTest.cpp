#include "WebRig.h"

#include <insonate/curriculum/FormStore.h>

#include <map>
#include <utility>

namespace insonate::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class WebComparison : public OnBoth {
 protected:
  void SetUp() override {
    OnBoth::SetUp();
    if (!IsSkipped()) school_.emplace(rig->open());
  }
  const WebSchool& school() const { return *school_; }
  /// Adds trainees with one attempt each, with these points.
  void fill(const std::string& cohort, const std::string& prefix, std::initializer_list<double> points) {
    const Curriculum curriculum = valueOf(loadCurriculum("central_line"));
    for (const double one : points) {
      const Person person = school().add(prefix + std::to_string(++added), Role::Trainee, cohort);
      AttemptFacts facts = endedFacts(begunFacts());
      facts.curriculumVersion = curriculum.version, facts.level = curriculum.levels.front().name;
      facts.procedure = curriculum.levels.front().procedure, facts.points = one;
      facts.recordingHash = std::string(62, 'b') + std::to_string(10 + added);
      valueOf(AttemptStore(school().as(person)).begin(facts));
      succeed(AttemptStore(school().as(person)).end(facts));
      last = person;
    }
  }
  /// A checklist with this answer to its first question; the others are done.
  static web::Fields answers(const std::string& first) {
    web::Fields fields{{"id", freshUuid()}};
    bool isFirst = true;
    for (const FormSection& section : valueOf(loadForm("jugular_checklist")).sections)
      for (const FormItem& item : section.items)
        fields.emplace("answer-" + item.name, std::exchange(isFirst, false) ? first : "done");
    return fields;
  }
  std::string comparison(const std::string& secret, const std::string& query = {}) const {
    return school().get("/classes/" + school().spring.id + "/comparison" + query, secret).body;
  }

  int added = 0;
  Person last;

 private:
  std::optional<WebSchool> school_;
};
INSONATE_ON_BOTH(WebComparison);

TEST_P(WebComparison, TwoClassesAreComparedWithNumbersAndAChart) {
  fill(school().spring.id, "s", {10, 20, 30, 40});
  fill(school().autumn.id, "f", {50, 60, 70, 80, 90});
  const std::string page = comparison(school().signIn("admin"), "?with=" + school().autumn.id + "&metric=points");
  // Anna's attempt of 81.25 points is the fifth of Spring.
  EXPECT_THAT(page, AllOf(HasSubstr("Spring: n = 5"), HasSubstr("Autumn: n = 5, mean 70, 95 % interval"),
                          HasSubstr("<svg"), HasSubstr("class=\"median\""), HasSubstr("Mann-Whitney, exact")));
  EXPECT_THAT(page, AllOf(HasSubstr("<td>30</td>"), HasSubstr("<td>70</td>"))) << "medians in the table";
  EXPECT_THAT(page, Not(HasSubstr("Dr s1"))) << "values have no names";
  EXPECT_THAT(comparison(school().signIn("ina")), HasSubstr("You can see only one class"));
  EXPECT_THAT(comparison(school().signIn("admin"), "?with=unknown&metric=<script>"),
              AllOf(HasSubstr("Autumn"), Not(HasSubstr("<script>"))));
}

TEST_P(WebComparison, TooFewValuesAreNotCompared) {
  fill(school().autumn.id, "f", {50, 60, 70, 80});
  EXPECT_THAT(comparison(school().signIn("admin"), "?with=" + school().autumn.id),
              HasSubstr("each class needs at least 4 people with values. Spring has 1, Autumn has 4."));
}

TEST_P(WebComparison, AnInstructorSeesThePlaceOfAPersonInTheClass) {
  const auto pageOf = [&](const Person& person, const std::string& name) {
    const std::string address = "/classes/" + school().spring.id + "/people/" + person.id;
    const std::string secret = school().signIn(name);
    return school().get(address, secret).body + school().get(address + "/comparison", secret).body;
  };
  EXPECT_THAT(pageOf(school().anna, "ina"), HasSubstr("Fewer than 4 people of the class have values"));
  fill(school().spring.id, "s", {10, 20, 90});
  EXPECT_THAT(pageOf(last, "ina"),
              AllOf(HasSubstr("Compare with the class"), HasSubstr("class=\"marked\""), HasSubstr("This person: 90."),
                    HasSubstr("Better than 100 % of the others in the class")));
  EXPECT_THAT(pageOf(school().ben, "ina"), HasSubstr("This person has no values"));
  EXPECT_THAT(pageOf(school().anna, "anna"),
              AllOf(HasSubstr("Not permitted"), Not(HasSubstr("Compare with the class"))))
      << "others' values";
}

TEST_P(WebComparison, TheAgreementOfRatersIsShownAndSaved) {
  const std::string raters = "/classes/" + school().spring.id + "/raters?form=jugular_checklist";
  const std::string ina = school().signIn("ina");
  EXPECT_THAT(school().get(raters, ina).body, HasSubstr("There is nothing to compare yet"));
  for (const auto& [who, answer] : std::map<std::string, std::string>{{"ina", "done"}, {"admin", "not_done"}}) {
    ASSERT_EQ(
        school()
            .post("/attempts/" + school().annas + "/forms/jugular_checklist", answers(answer), school().signIn(who))
            .status,
        303);
  }
  const std::string page = school().get(raters, ina).body;
  EXPECT_THAT(page, AllOf(HasSubstr("Dr ina"), HasSubstr("Ada Min"), HasSubstr("95 %"),
                          HasSubstr("Judged by two or more raters: 1.")));
  const web::Response csv =
      school().get("/classes/" + school().spring.id + "/raters/agreement.csv?form=jugular_checklist", ina);
  EXPECT_EQ(csv.status, 200);
  EXPECT_THAT(headerOf(csv, "Content-Disposition"), HasSubstr("raters.csv"));
  EXPECT_EQ(csv.body,
            agreementCsv(valueOf(loadForm("jugular_checklist")),
                         valueOf(FormStore(school().as(school().ina))
                                     .agreement(school().spring.id, valueOf(loadForm("jugular_checklist"))))));
  const Person uta = school().add("uta", Role::Instructor, school().spring.id);
  const std::string secret = school().signIn("uta");
  EXPECT_THAT(school().get(raters, secret).body, HasSubstr("Judged by two or more raters: 1."));
  AttemptFacts other = begunFacts();
  const std::string second = keepAttempt(school().as(school().ben), other).id;
  ASSERT_EQ(school().post("/attempts/" + second + "/forms/jugular_checklist", answers("done"), secret).status, 303);
  EXPECT_THAT(school().get(raters, secret).body, HasSubstr("Judged by two or more raters: 0."))
      << "a rater sees nothing of the attempts that this rater has not judged";
  EXPECT_THAT(school().get(raters + "x", ina).body, HasSubstr("Agreement of raters of Spring")) << "an unknown form";
}

TEST_P(WebComparison, APortfolioHasLevelsCurvesChecklistsAndAllAttempts) {
  web::Fields fields = answers("done");
  fields.emplace("note-consent", "a <remark>");
  ASSERT_EQ(
      school().post("/attempts/" + school().annas + "/forms/jugular_checklist", fields, school().signIn("ina")).status,
      303);
  const std::string own = school().get("/me/portfolio", school().signIn("anna")).body;
  const std::string ofIna =
      school()
          .get("/classes/" + school().spring.id + "/people/" + school().anna.id + "/portfolio", school().signIn("ina"))
          .body;
  for (const std::string& page : {own, ofIna})
    EXPECT_THAT(page, AllOf(HasSubstr("Portfolio of Dr anna"), HasSubstr("Learning curves"), HasSubstr("<svg"),
                            HasSubstr("<details open"), HasSubstr("a &lt;remark&gt;"), HasSubstr("All attempts"),
                            HasSubstr("81.3")));
  EXPECT_THAT(own, HasSubstr("Read by Dr anna"));
  succeed(AttemptStore(school().as(school().ina)).voidAttempt(school().annas, "device failed"));
  EXPECT_THAT(school().get("/me/portfolio", school().signIn("anna")).body, HasSubstr(", Voided."))
      << "a checklist of an attempt that does not count";
  EXPECT_THAT(school().get("/me/portfolio", school().signIn("ben")).body, HasSubstr("No attempts at levels yet."));
}

}  // namespace
}  // namespace insonate::test
