#include "image/CalliperTool.h"

#include <gtest/gtest.h>

namespace insonate::train {
namespace {

using views::CalliperKind;

TEST(CalliperTool, DragIsADistance) {
  CalliperTool tool;
  tool.setKind(CalliperKind::Distance);
  tool.pressed({0, 10});
  tool.moved({3, 12});
  EXPECT_TRUE(tool.placing());
  tool.released({3, 14});
  EXPECT_FALSE(tool.placing());
  ASSERT_EQ(tool.callipers().size(), 1u);
  EXPECT_DOUBLE_EQ(views::measure(tool.callipers()[0]).length_mm, 5);
}

TEST(CalliperTool, ClicksAreADistance) {
  CalliperTool tool;
  tool.setKind(CalliperKind::Distance);
  tool.pressed({0, 10});
  tool.released({0.1, 10});
  EXPECT_TRUE(tool.placing());
  tool.moved({0, 18});
  EXPECT_DOUBLE_EQ(views::measure(tool.callipers()[0]).length_mm, 8) << "seen while it is placed";
  tool.pressed({0, 20});
  tool.released({0, 20});
  ASSERT_EQ(tool.callipers().size(), 1u);
  EXPECT_DOUBLE_EQ(views::measure(tool.callipers()[0]).length_mm, 10);
}

TEST(CalliperTool, AngleTakesThreePoints) {
  CalliperTool tool;
  tool.setKind(CalliperKind::Angle);
  for (const views::PicturePoint point : {views::PicturePoint{10, 0}, {0, 0}, {0, 10}}) {
    tool.moved(point);
    tool.pressed(point);
    tool.released(point);
  }
  EXPECT_FALSE(tool.placing());
  EXPECT_NEAR(views::measure(tool.callipers().at(0)).angle_deg, 90, 1e-9);
}

TEST(CalliperTool, DragThenClickIsAnEllipse) {
  CalliperTool tool;
  tool.setKind(CalliperKind::Ellipse);
  tool.pressed({-5, 10});
  tool.released({5, 10});
  EXPECT_TRUE(tool.placing());
  tool.pressed({0, 13});
  EXPECT_FALSE(tool.placing());
  EXPECT_DOUBLE_EQ(views::measure(tool.callipers().at(0)).length_mm, 10);
  EXPECT_DOUBLE_EQ(views::measure(tool.callipers().at(0)).width_mm, 6);
}

TEST(CalliperTool, AnotherKindDropsWhatIsNotComplete) {
  CalliperTool tool;
  tool.setKind(CalliperKind::Distance);
  tool.pressed({0, 10});
  tool.setKind(CalliperKind::Angle);
  EXPECT_TRUE(tool.callipers().empty());
  tool.setKind(std::nullopt);
  tool.pressed({0, 10});
  EXPECT_TRUE(tool.callipers().empty()) << "nothing is measured without a kind";
}

}  // namespace
}  // namespace insonate::train
