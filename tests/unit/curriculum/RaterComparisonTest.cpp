#include <insonate/curriculum/RaterComparison.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace insonate {
namespace {

FormItem itemOf(const std::string& name, const std::vector<FormOption>& options) {
  FormItem item;
  item.name = item.title = name;
  item.options = options;
  return item;
}

/// Three items done or not, one of three words without points.
Form checklist() {
  const std::vector<FormOption> done{{"yes", "Yes", 1}, {"no", "No", 0}, {"unseen", "Not seen", {}}};
  Form form;
  form.name = "f";
  form.sections = {{"S",
                    "",
                    {itemOf("a", done), itemOf("b", done), itemOf("c", done),
                     itemOf("words", {{"x", "X", {}}, {"y", "Y", {}}, {"z", "Z", {}}})}}};
  return form;
}

FormAnswers answers(const std::string& a, const std::string& b, const std::string& c) {
  return {{"a", a}, {"b", b}, {"c", c}, {"words", "x"}};
}

TEST(RaterComparison, ChecklistsByHand) {
  // Pairs: yes-yes, yes-no, no-no | yes-yes, no-yes; "unseen" is none. 3 of 5 alike.
  const RaterComparison comparison = compareRaters(
      checklist(), std::vector<RatedTwice>{{answers("yes", "yes", "no"), answers("yes", "no", "no")},
                                           {answers("yes", "no", "unseen"), answers("yes", "yes", "no")}});
  EXPECT_EQ(comparison.pairs, 5);
  EXPECT_DOUBLE_EQ(*comparison.agreement, 0.6);
  // Each says yes 3 times of 5: pe = 9/25 + 4/25 = 0.52, kappa = (0.6 - 0.52) / 0.48 = 1/6.
  EXPECT_NEAR(*comparison.kappa, 1 / 6.0, 1e-12);
  EXPECT_THAT(comparison.differing, testing::ElementsAre("b"));
  EXPECT_TRUE(comparison.scores);
}

TEST(RaterComparison, ScalesAreWeightedByTheirPoints) {
  // Written from the best to the worst: grades follow the points, not the order.
  const FormItem item = itemOf("g", {{"good", "Good", 3}, {"fair", "Fair", 2}, {"poor", "Poor", 1}});
  Form form;
  form.sections = {{"S", "", {item}}};
  std::vector<RatedTwice> attempts;
  for (const auto& [first, second] : std::vector<std::pair<std::string, std::string>>{
           {"poor", "poor"}, {"fair", "fair"}, {"good", "fair"}, {"good", "good"}})
    attempts.push_back({{{"g", first}}, {{"g", second}}});
  // As in AgreementTest: expected squares 20/16, seen 1/4.
  EXPECT_NEAR(*compareRaters(form, attempts).kappa, 0.8, 1e-12);
}

TEST(RaterComparison, WhereNothingIsRatedTwiceThereIsNoValue) {
  const RaterComparison none = compareRaters(checklist(), {});
  EXPECT_EQ(none.pairs, 0);
  EXPECT_FALSE(none.agreement || none.kappa || none.scores);
  EXPECT_TRUE(none.differing.empty());
  const RaterComparison odd =
      compareRaters(checklist(), std::vector<RatedTwice>{{{{"a", 1.0}, {"b", "other"}}, answers("yes", "yes", "yes")}});
  EXPECT_EQ(odd.pairs, 0);
  EXPECT_FALSE(compareRaters(Form{}, std::vector<RatedTwice>{{}}).agreement);
}

TEST(RaterComparison, TheFormsThatComeAlong) {
  const auto rating = loadForm("global_rating");
  ASSERT_TRUE(rating) << rating.error().message;
  std::vector<RatedTwice> attempts(3);
  for (std::size_t i = 0; i < attempts.size(); ++i)
    for (const FormItem& item : rating->sections[0].items)
      if (item.options.size() == 5)
        attempts[i].first[item.name] = attempts[i].second[item.name] = item.options[i + 1].name;
  const RaterComparison comparison = compareRaters(*rating, attempts);
  EXPECT_EQ(comparison.pairs, 21);  // seven domains; the last question has no points
  EXPECT_EQ(comparison.agreement, 1);
  EXPECT_EQ(comparison.kappa, 1);
  EXPECT_DOUBLE_EQ(comparison.scores->value, 1);
}

}  // namespace
}  // namespace insonate
