#include "image/CaliperTool.h"

#include <gtest/gtest.h>

namespace insonate::train {
namespace {

using views::CaliperKind;

TEST(CaliperTool, DragIsADistance) {
  CaliperTool tool;
  tool.setKind(CaliperKind::Distance);
  tool.pressed({0, 10});
  tool.moved({3, 12});
  EXPECT_TRUE(tool.placing());
  tool.released({3, 14});
  EXPECT_FALSE(tool.placing());
  ASSERT_EQ(tool.calipers().size(), 1u);
  EXPECT_DOUBLE_EQ(views::measure(tool.calipers()[0]).length_mm, 5);
}

TEST(CaliperTool, ClicksAreADistance) {
  CaliperTool tool;
  tool.setKind(CaliperKind::Distance);
  tool.pressed({0, 10});
  tool.released({0.1, 10});
  EXPECT_TRUE(tool.placing());
  tool.moved({0, 18});
  EXPECT_DOUBLE_EQ(views::measure(tool.calipers()[0]).length_mm, 8) << "seen while it is placed";
  tool.pressed({0, 20});
  tool.released({0, 20});
  ASSERT_EQ(tool.calipers().size(), 1u);
  EXPECT_DOUBLE_EQ(views::measure(tool.calipers()[0]).length_mm, 10);
}

TEST(CaliperTool, AngleTakesThreePoints) {
  CaliperTool tool;
  tool.setKind(CaliperKind::Angle);
  for (const views::ImagePoint point : {views::ImagePoint{10, 0}, {0, 0}, {0, 10}}) {
    tool.moved(point);
    tool.pressed(point);
    tool.released(point);
  }
  EXPECT_FALSE(tool.placing());
  EXPECT_NEAR(views::measure(tool.calipers().at(0)).angle_deg, 90, 1e-9);
}

TEST(CaliperTool, DragThenClickIsAnEllipse) {
  CaliperTool tool;
  tool.setKind(CaliperKind::Ellipse);
  tool.pressed({-5, 10});
  tool.released({5, 10});
  EXPECT_TRUE(tool.placing());
  tool.pressed({0, 13});
  EXPECT_FALSE(tool.placing());
  EXPECT_DOUBLE_EQ(views::measure(tool.calipers().at(0)).length_mm, 10);
  EXPECT_DOUBLE_EQ(views::measure(tool.calipers().at(0)).width_mm, 6);
}

TEST(CaliperTool, AnotherKindDropsWhatIsNotComplete) {
  CaliperTool tool;
  tool.setKind(CaliperKind::Distance);
  tool.pressed({0, 10});
  tool.setKind(CaliperKind::Angle);
  EXPECT_TRUE(tool.calipers().empty());
  tool.setKind(std::nullopt);
  tool.pressed({0, 10});
  EXPECT_TRUE(tool.calipers().empty()) << "nothing is measured without a kind";
}

}  // namespace
}  // namespace insonate::train
