#include <insonate/curriculum/FormAgreement.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace insonate {
namespace {

using testing::ElementsAre;

Form checklist() {
  const auto form = loadForm("jugular_checklist");
  return form ? *form : Form{};
}

/// Says `done` of the first item, and that all others were done.
StoredForm judged(const std::string& rater, const std::string& attempt, bool done) {
  const Form form = checklist();
  FormAnswers answers;
  for (const FormSection& section : form.sections)
    for (const FormItem& item : section.items) answers[item.name] = "done";
  if (!done) answers["indication"] = "not_done";
  StoredForm kept;
  kept.filled = {.form = form.name,
                 .formVersion = form.version,
                 .person = "trainee",
                 .attempt = attempt,
                 .by = "id of " + rater,
                 .answers = answersText(answers)};
  kept.rater = rater;
  return kept;
}

TEST(FormAgreement, EachTwoRatersAreComparedOverWhatBothJudged) {
  const std::vector<StoredForm> forms{judged("Ina", "1", true),   judged("Otto", "1", true), judged("Ina", "2", true),
                                      judged("Otto", "2", false), judged("Max", "2", true),  judged("Ina", "3", true)};
  const FormAgreement agreement = agreementOf(checklist(), forms);
  EXPECT_EQ(agreement.judged, 3);
  EXPECT_EQ(agreement.judgedTwice, 2);
  ASSERT_EQ(agreement.pairs.size(), 3U);
  const RaterPair &maxWithIna = agreement.pairs[0], &both = agreement.pairs[1];
  EXPECT_EQ(maxWithIna.first + ", " + maxWithIna.second, "Ina, Max");
  EXPECT_EQ(maxWithIna.attempts, 1);
  EXPECT_EQ(maxWithIna.comparison.agreement, 1);
  EXPECT_FALSE(maxWithIna.comparison.kappa) << "both say always done: chance alone would agree, too";
  EXPECT_EQ(both.first + ", " + both.second, "Ina, Otto");
  EXPECT_EQ(both.attempts, 2);
  EXPECT_EQ(both.comparison.pairs, 44);
  EXPECT_DOUBLE_EQ(*both.comparison.agreement, 43.0 / 44);
  EXPECT_THAT(both.comparison.differing, ElementsAre("indication"));
  EXPECT_EQ(both.comparison.items.front().agreement, 0.5);
  EXPECT_EQ(both.comparison.items.back().agreement, 1);
}

TEST(FormAgreement, OfOneRatersTheFirstCountsAndNobodyJudgesThemselves) {
  StoredForm own = judged("The trainee", "1", false);
  own.filled.by = own.filled.person;
  StoredForm withheld = judged("Max", "1", false);
  withheld.withheld = true, withheld.filled.answers.clear();
  StoredForm old = judged("Olga", "1", false), other = judged("Ulla", "1", false), none = judged("Nils", "", false);
  old.filled.formVersion = 99, other.filled.form = "another", none.filled.attempt.clear();
  StoredForm broken = judged("Bob", "1", true);
  broken.filled.answers = "{";
  const FormAgreement agreement = agreementOf(
      checklist(), std::vector<StoredForm>{judged("Ina", "1", true), judged("Otto", "1", true),
                                           judged("Ina", "1", false), own, withheld, old, other, none, broken});
  ASSERT_EQ(agreement.pairs.size(), 1U);
  EXPECT_EQ(agreement.pairs[0].comparison.agreement, 1) << "Ina, who knows the others by then, is not heard again";
  EXPECT_EQ(agreement.otherVersions, 1);
  EXPECT_EQ(agreement.judged, 1);
}

TEST(FormAgreement, TwoRatersOfOneNameAreTwo) {
  StoredForm first = judged("A. Same", "1", true), second = judged("A. Same", "1", false);
  second.filled.by = "somebody else";
  EXPECT_EQ(agreementOf(checklist(), std::vector<StoredForm>{first, second}).pairs.size(), 1U);
}

TEST(FormAgreement, OfNothingThereIsNothing) {
  const FormAgreement agreement = agreementOf(checklist(), {});
  EXPECT_EQ(agreement.judged, 0);
  EXPECT_TRUE(agreement.pairs.empty());
}

}  // namespace
}  // namespace insonate
