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
      checklist(), std::vector<RatingPair>{{answers("yes", "yes", "no"), answers("yes", "no", "no")},
                                           {answers("yes", "no", "unseen"), answers("yes", "yes", "no")}});
  EXPECT_EQ(comparison.pairs, 5);
  EXPECT_DOUBLE_EQ(*comparison.agreement, 0.6);
  // Each says yes 3 times of 5: pe = 9/25 + 4/25 = 0.52, kappa = (0.6 - 0.52) / 0.48 = 1/6.
  EXPECT_NEAR(*comparison.kappa, 1 / 6.0, 1e-12);
  EXPECT_THAT(comparison.differing, testing::ElementsAre("b"));
  EXPECT_TRUE(comparison.scores);
  ASSERT_EQ(comparison.items.size(), 4U);
  EXPECT_EQ(comparison.items[0].item, "a");
  EXPECT_EQ(comparison.items[0].agreement, 1);
  EXPECT_FALSE(comparison.items[0].kappa) << "always yes";
  // b: yes-no and no-yes. Half and half by chance would agree in half: (0 - 0.5) / 0.5.
  EXPECT_EQ(comparison.items[1].agreement, 0);
  EXPECT_NEAR(*comparison.items[1].kappa, -1, 1e-12);
  EXPECT_EQ(comparison.items[2].pairs, 1);
  EXPECT_EQ(comparison.items[3].pairs, 2);
  EXPECT_EQ(comparison.items[3].agreement, 1);
  EXPECT_FALSE(comparison.items[3].points) << "words have no points";
}

TEST(RaterComparison, AnswersWithoutPointsAreComparedButNotWeighted) {
  Form form;
  form.sections = {{"S", "", {itemOf("ready", {{"no", "No", {}}, {"with", "With help", {}}, {"yes", "Yes", {}}})}}};
  std::vector<RatingPair> attempts;
  for (const auto& [first, second] :
       std::vector<std::pair<std::string, std::string>>{{"no", "no"}, {"with", "yes"}, {"yes", "yes"}, {"yes", "no"}})
    attempts.push_back({{{"ready", first}}, {{"ready", second}}});
  const RaterComparison comparison = compareRaters(form, attempts);
  ASSERT_EQ(comparison.items.size(), 1U);
  // Two of four alike; by chance no 1/4 * 2/4, with 1/4 * 0, yes 2/4 * 2/4, in all 6/16: (8/16 - 6/16) / (10/16).
  EXPECT_EQ(comparison.items[0].agreement, 0.5);
  EXPECT_NEAR(*comparison.items[0].kappa, 0.2, 1e-12);
  EXPECT_EQ(comparison.pairs, 0) << "the whole form has no grades";
}

TEST(RaterComparison, PointsOfAnItemByThePublishedTable) {
  // The first two judges of table 2 of Shrout and Fleiss 1979, whose mean squares are 4.683 (subjects), 80.083
  // (judges) and 0.683 (rest): 4 / (5.367 + 2 * 79.4 / 6).
  std::vector<FormOption> options;
  for (int points = 1; points <= 10; ++points)
    options.push_back({std::to_string(points), std::to_string(points), points});
  Form form;
  form.sections = {{"S", "", {itemOf("g", options)}}};
  std::vector<RatingPair> attempts;
  for (const auto& [first, second] : std::vector<std::pair<int, int>>{{9, 2}, {6, 1}, {8, 4}, {7, 1}, {10, 5}, {6, 2}})
    attempts.push_back({{{"g", std::to_string(first)}}, {{"g", std::to_string(second)}}});
  const ItemAgreement item = compareRaters(form, attempts).items.at(0);
  ASSERT_TRUE(item.points && item.points->interval);
  EXPECT_NEAR(item.points->value, 4 / (5 + 11 / 30.0 + 79.4 / 3), 1e-9);
  EXPECT_LT(item.points->interval->low, item.points->value);
}

TEST(RaterComparison, ScalesAreWeightedByTheirPoints) {
  // Written from the best to the worst: grades follow the points, not the order.
  const FormItem item = itemOf("g", {{"good", "Good", 3}, {"fair", "Fair", 2}, {"poor", "Poor", 1}});
  Form form;
  form.sections = {{"S", "", {item}}};
  std::vector<RatingPair> attempts;
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
      compareRaters(checklist(), std::vector<RatingPair>{{{{"a", 1.0}, {"b", "other"}}, answers("yes", "yes", "yes")}});
  EXPECT_EQ(odd.pairs, 0);
  EXPECT_FALSE(compareRaters(Form{}, std::vector<RatingPair>{{}}).agreement);
}

TEST(RaterComparison, TheFormsThatComeAlong) {
  const auto rating = loadForm("global_rating");
  ASSERT_TRUE(rating) << rating.error().message;
  std::vector<RatingPair> attempts(3);
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
