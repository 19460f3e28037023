#include "Classroom.h"
#include "compare/ClassComparison.h"

#include <insonate/teaching/MetricCatalog.h>
#include <insonate/ui/Chart.h>

#include <QComboBox>
#include <QLabel>
#include <QToolButton>

namespace insonate::review {
namespace {

/// People with these points.
HeatMap classOf(std::initializer_list<double> points) {
  HeatMap heat;
  for (const double one : points) {
    auto& row = heat["p" + std::to_string(heat.size())];
    row.resize(MetricCatalog::instance().comparableCount());
    row[0] = {one, one, 10};
  }
  return heat;
}

class Compare : public Classroom {};

TEST_F(Compare, TwoClassesHaveNumbersAndAnEffectSize) {
  const HeatMap low = classOf({10, 20, 30, 40}), high = classOf({50, 60, 70, 80, 90});
  const ClassComparison result = compareClasses({"A %1", low}, {"B %2", high}, 0);
  ASSERT_EQ(result.picture.boxes.size(), 2U);
  ASSERT_EQ(result.picture.lines.size(), 2U);
  EXPECT_EQ(result.picture.lines[1].points.size(), 5U) << "a dot each";
  EXPECT_TRUE(result.words.contains("In both classes: 4 people")) << result.words.toStdString();
  EXPECT_EQ(result.picture.boxes[0].numbers.median, 25);
  EXPECT_EQ(result.picture.boxes[1].numbers.median, 70);
  // All 20 pairs lie one way: p = 2 / C(9, 4) = 0.0159.
  EXPECT_TRUE(result.words.contains("A %1: n = 4, mean 25, no interval: fewer than 5 values"))
      << result.words.toStdString();
  EXPECT_TRUE(result.words.contains("B %2: n = 5, mean 70, 95 % interval 52")) << result.words.toStdString();
  EXPECT_TRUE(result.words.contains("(bootstrap)")) << result.words.toStdString();
  EXPECT_TRUE(
      result.words.contains("delta) -1.00: in 0 % of pairs the person of A %1 has a higher value than the person of B "
                            "%2 (equal values count half); p = 0.016 (Mann-Whitney, exact)"))
      << result.words.toStdString();
}

TEST_F(Compare, TooFewAreNotCompared) {
  const HeatMap few = classOf({10, 20, 30}), many = classOf({50, 60, 70, 80});
  const ClassComparison result = compareClasses({"A", few}, {"B", many}, 0);
  EXPECT_TRUE(result.picture.isEmpty());
  EXPECT_TRUE(result.words.startsWith("n/a: 3 people in A")) << result.words.toStdString();
}

TEST_F(Compare, OnlyWhoSeesTwoClassesCompares) {
  practise(school_->as(school_->anna), true, 2);
  enter("ina");
  child<QToolButton>("compareTab")->click();
  EXPECT_TRUE(child<ui::Chart>("comparisonChart")->picture().words.contains("only one class"));
  workspace_.reset();
  enter("admin");
  child<QToolButton>("compareTab")->click();
  EXPECT_EQ(child<QComboBox>("otherClass")->currentText(), "Spring") << "the only other one";
  EXPECT_EQ(child<QComboBox>("otherClass")->findText("Autumn"), -1) << "not with itself";
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return child<QLabel>("comparisonWords")->text().startsWith("n/a: 0 people in Autumn"); }, kPatience_ms));
}

TEST_F(Compare, ATraineeHasNoSuchTab) {
  enter("anna");
  EXPECT_FALSE(isSeen("compareTab"));
}

}  // namespace
}  // namespace insonate::review
