#include "StoreRig.h"

#include <insonate/curriculum/AuditLog.h>
#include <insonate/curriculum/FormStore.h>

namespace insonate::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

class StoreForms : public OnBoth {};
INSONATE_ON_BOTH(StoreForms);

/// A second rater beside Ina, and an attempt of Anna's that both judge.
struct Judging {
  explicit Judging(const School& school)
      : uta(school.add("uta", Role::Instructor, school.spring.id)),
        attempt(keepAttempt(school.as(school.anna))),
        ina(school.as(school.ina)),
        form(valueOf(loadForm("jugular_checklist"))) {
    attempt.person = school.anna.id;
    succeed(CohortStore(school.admin).join(school.spring.id, uta.id, true));
  }

  std::string judge(const SignedIn& by, const std::string& indication) const {
    FormAnswers answers;
    for (const FormSection& section : form.sections)
      for (const FormItem& item : section.items) answers[item.name] = "done";
    answers["indication"] = indication;
    return valueOf(
        FormStore(by).add({"", form.name, form.version, attempt.person, attempt.id, "", 0, answersText(answers)}));
  }

  Person uta;
  AttemptFacts attempt;
  SignedIn ina;
  Form form;
};

TEST_P(StoreForms, ARaterReadsOthersJudgementsAfterTheirOwn) {
  const School school(rig->open());
  const Judging judging(school);
  const SignedIn uta = school.as(judging.uta);
  judging.judge(judging.ina, "done");

  for (const SignedIn& other : {uta, school.admin})
    for (const auto& forms : {valueOf(FormStore(other).listByAttempt(judging.attempt.id)),
                              valueOf(FormStore(other).listByPerson(school.anna.id)),
                              valueOf(FormStore(other).listByCohort(school.spring.id, judging.form.name))}) {
      ASSERT_EQ(forms.size(), 1U);
      EXPECT_TRUE(forms[0].withheld);
      EXPECT_THAT(forms[0].filled.answers, IsEmpty());
      EXPECT_EQ(forms[0].rater, "Dr ina") << "who has judged is known, not how";
    }

  const AttemptFacts another = keepAttempt(school.as(school.anna));
  valueOf(FormStore(uta).add({"", "global_rating", 1, school.anna.id, judging.attempt.id, "", 0, "{}"}));
  valueOf(FormStore(uta).add({"", judging.form.name, 1, school.anna.id, another.id, "", 0, "{}"}));
  EXPECT_TRUE(valueOf(FormStore(uta).listByAttempt(judging.attempt.id))[0].withheld)
      << "neither another form nor another attempt opens it";

  judging.judge(uta, "not_done");
  const auto forms = valueOf(FormStore(uta).listByAttempt(judging.attempt.id));
  EXPECT_FALSE(forms[0].withheld);
  EXPECT_THAT(forms[0].filled.answers, HasSubstr("indication"));
}

TEST_P(StoreForms, AFormAboutAnAttemptIsHandedInOnce) {
  const School school(rig->open());
  const Judging judging(school);
  const std::string id = judging.judge(judging.ina, "done");
  FilledForm again{"", judging.form.name, judging.form.version, school.anna.id, judging.attempt.id, "", 0, "{}"};
  const auto second = FormStore(judging.ina).add(again);
  ASSERT_FALSE(second);
  EXPECT_THAT(second.error().message, HasSubstr("a form can be handed in only once"));
  const auto kept = valueOf(FormStore(judging.ina).listByAttempt(judging.attempt.id));
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_EQ(valueOf(FormStore(judging.ina).add(kept[0].filled)), id) << "the same sheet sent again is no error";
  valueOf(FormStore(school.as(judging.uta)).add(again));
  again.form = "global_rating";
  valueOf(FormStore(judging.ina).add(again));
  const AttemptFacts another = keepAttempt(school.as(school.anna));
  again.form = judging.form.name, again.attempt = another.id;
  valueOf(FormStore(judging.ina).add(again));
}

TEST_P(StoreForms, WhomTheyAreAboutReadsThemAndOwnWordsAreNeverWithheld) {
  const School school(rig->open());
  const Judging judging(school);
  judging.judge(judging.ina, "done");
  valueOf(FormStore(school.as(school.anna))
              .add({"", "simulator_questionnaire", 1, school.anna.id, judging.attempt.id, "", 0, R"({"a": "b"})"}));
  for (const StoredForm& one : valueOf(FormStore(school.as(school.anna)).listByAttempt(judging.attempt.id)))
    EXPECT_FALSE(one.withheld);
  const auto seen = valueOf(FormStore(school.as(judging.uta)).listByAttempt(judging.attempt.id));
  EXPECT_TRUE(seen[0].withheld);
  EXPECT_FALSE(seen[1].withheld) << "what trainees say of themselves is no judgement";
}

TEST_P(StoreForms, TheAgreementOfAClassTellsFiguresAndIsLogged) {
  const School school(rig->open());
  const Judging judging(school);
  const SignedIn uta = school.as(judging.uta);
  judging.judge(judging.ina, "done");
  judging.judge(uta, "not_done");
  const FormAgreement agreement = valueOf(FormStore(school.admin).agreement(school.spring.id, judging.form));
  ASSERT_EQ(agreement.pairs.size(), 1U) << "who has not judged reads the figures, too";
  EXPECT_EQ(agreement.pairs[0].first, "Dr ina");
  EXPECT_DOUBLE_EQ(*agreement.pairs[0].comparison.agreement, 21.0 / 22);
  const AuditEntry entry = valueOf(AuditLog(school.admin).page(2))[1];
  EXPECT_EQ(entry.act, "see cohort's forms");
  EXPECT_EQ(entry.detail, "agreement, cohort " + school.spring.id + ", learners 2");
}

TEST_P(StoreForms, AnAttemptIsFoundByItsRecording) {
  const School school(rig->open());
  const SignedIn anna = school.as(school.anna);
  AttemptFacts facts = begunFacts();
  facts = endedFacts(facts);
  valueOf(AttemptStore(anna).begin(facts));
  succeed(AttemptStore(anna).end(facts));
  const AttemptStore otto(school.as(school.otto));
  EXPECT_EQ(valueOf(otto.findByRecording("renamed.attempt", facts.recordingHash)), facts.id);
  EXPECT_EQ(valueOf(otto.findByRecording(facts.recording, std::string(64, 'b'))), facts.id) << "the file was changed";
  EXPECT_EQ(valueOf(otto.findByRecording("other.attempt", std::string(64, 'b'))), "");
  EXPECT_EQ(valueOf(otto.findByRecording("", "")), "");
  EXPECT_FALSE(otto.attempt(facts.id)) << "which attempt it is, is not who may see it";
  rig->services.workstation = "ward 8";
  const CurriculumStore elsewhere = rig->open();
  const SignedIn there = valueOf(elsewhere.signIn("otto", kPassword));
  EXPECT_EQ(valueOf(AttemptStore(there).findByRecording(facts.recording, "")), "") << "names are a workstation's own";
}

}  // namespace
}  // namespace insonate::test
