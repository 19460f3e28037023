#include "probe/FitCanvas.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace insonate::train {
namespace {

TEST(FitHandles, SidesMoveAloneAndTheRestFollows) {
  FovShape fan;
  fan.shape = ProbeShape::Curvilinear, fan.origin = {100, 50}, fan.alpha_deg = 60, fan.r1_px = 40, fan.r2_px = 200;
  const PixelPoint left = pointAtFraction(fan, -1, 0.5);
  FovShape moved = draggedTo(fan, FitCanvas::Handle::Right, {100 + 120 * std::sin(0.7), 50 + 120 * std::cos(0.7)}, {});
  EXPECT_NEAR(moved.alpha_deg, 30 + 0.7 * 180 / std::numbers::pi, 1e-9);
  EXPECT_NEAR(pointAtFraction(moved, -1, 0.5).x, left.x, 1e-9);
  EXPECT_NEAR(pointAtFraction(moved, -1, 0.5).y, left.y, 1e-9);
  moved = draggedTo(fan, FitCanvas::Handle::End, {100, 300}, {});
  EXPECT_NEAR(moved.r2_px, 250, 1e-9);
  FovShape box;
  box.origin = {100, 20}, box.width_px = 80, box.depth_px = 120;
  moved = draggedTo(box, FitCanvas::Handle::Left, {40, 60}, {});
  EXPECT_NEAR(moved.width_px, 100, 1e-9);
  EXPECT_NEAR(pointAtFraction(moved, 1, 0).x, 140, 1e-9) << "the other side stays";
  moved = draggedTo(box, FitCanvas::Handle::Face, {100, 50}, {});
  EXPECT_NEAR(moved.depth_px, 90, 1e-9);
  EXPECT_NEAR(pointAtFraction(moved, 0, 1).y, 140, 1e-9) << "the end stays";
  moved = draggedTo(box, FitCanvas::Handle::Whole, {105, 47}, {100, 50});
  EXPECT_NEAR(moved.origin.x, 105, 1e-9);
}

}  // namespace
}  // namespace insonate::train
