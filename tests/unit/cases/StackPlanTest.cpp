#include "CaseSamples.h"
#include "import/StackPlan.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

namespace insonate {
namespace {

using testing::HasSubstr;

SliceStack axialStack(const std::vector<double>& z_mm) {
  SliceStack stack{32, 24, {0.5, 0.8}, {Vec3{1, 0, 0}, Vec3{0, 1, 0}}, {}, 2};
  for (double z : z_mm) stack.positions_mm.push_back({-10, -20, z});
  return stack;
}

std::vector<double> ladder(int count, double step) {
  std::vector<double> z;
  for (int n = 0; n < count; ++n) z.push_back(n * step);
  return z;
}

TEST(StackPlan, EvenSlicesInAnyOrder) {
  const StackPlan plan = planStack(axialStack({4.2, 0, 2.8, 1.4}));
  EXPECT_EQ(plan.refusal, "");
  EXPECT_FALSE(plan.resample);
  EXPECT_THAT(plan.order, testing::ElementsAre(1, 3, 2, 0));
  EXPECT_EQ(plan.grid.size, (std::array{32, 24, 4}));
  EXPECT_EQ(plan.grid.spacing_mm, (Vec3{0.5, 0.8, 1.4})) << "no rounding noise";
  EXPECT_EQ(plan.grid.origin_mm, (Vec3{-10, -20, 0}));
  EXPECT_THAT(plan.warnings, testing::IsEmpty());
}

TEST(StackPlan, CoronalSlicesAreRightHanded) {
  SliceStack stack = axialStack({0, 0, 0});
  stack.direction = {Vec3{1, 0, 0}, Vec3{0, 0, -1}};
  for (int n = 0; n < 3; ++n) stack.positions_mm[n] = {0, -5.0 * n, 100};
  const StackPlan plan = planStack(stack);
  EXPECT_GT(determinant(plan.grid.direction), 0.99);
  EXPECT_EQ(plan.grid.direction.column[2], (Vec3{0, 1, 0}));
  EXPECT_EQ(plan.grid.origin_mm, (Vec3{0, -10, 100}));
}

TEST(StackPlan, RoundedPositionsAreEven) {
  std::vector<double> z;
  for (int n = 0; n < 50; ++n) z.push_back(std::round(n * 0.625 * 10) / 10);  // scanners that print one decimal
  const StackPlan plan = planStack(axialStack(z));
  EXPECT_FALSE(plan.resample);
  EXPECT_NEAR(plan.grid.spacing_mm.z, 0.625, 0.002);
}

TEST(StackPlan, MissingSliceIsNamedAndInterpolated) {
  std::vector<double> z = ladder(10, 2.5);
  z.erase(z.begin() + 4);
  const StackPlan plan = planStack(axialStack(z));
  EXPECT_EQ(plan.refusal, "");
  EXPECT_TRUE(plan.resample);
  EXPECT_EQ(plan.grid.size[2], 10);
  EXPECT_THAT(plan.warnings, testing::ElementsAre(HasSubstr("1 slice is missing, at 10.0 mm")));
}

TEST(StackPlan, LargeGapIsRefused) {
  std::vector<double> z = ladder(20, 2.5);
  z.erase(z.begin() + 5, z.begin() + 10);
  const StackPlan plan = planStack(axialStack(z));
  EXPECT_THAT(plan.refusal, HasSubstr("5 slices are missing, at 12.5, 15.0, 17.5, 20.0, 22.5 mm"));
}

TEST(StackPlan, VariableSpacingIsResampledToTheFiner) {
  const StackPlan plan = planStack(axialStack({0, 3, 6, 9, 10.3, 11.6, 12.9}));
  EXPECT_EQ(plan.refusal, "");
  EXPECT_TRUE(plan.resample);
  EXPECT_DOUBLE_EQ(plan.grid.spacing_mm.z, 1.3);
  EXPECT_THAT(plan.warnings, testing::ElementsAre(HasSubstr("1.30 to 3.00 mm apart")));
}

TEST(StackPlan, SingleSliceTakesItsThickness) {
  const StackPlan plan = planStack(axialStack({7}));
  EXPECT_EQ(plan.grid.spacing_mm.z, 2);
  EXPECT_THAT(plan.warnings, testing::ElementsAre(HasSubstr("only one slice")));
}

TEST(StackPlan, RowsAndColumnsMustBeSquare) {
  SliceStack stack = axialStack({0, 1});
  stack.direction[1] = normalized({0.1, 1, 0});
  EXPECT_THAT(planStack(stack).refusal, HasSubstr("right angles"));
}

/// HU as a linear function of place: linear interpolation must reproduce it exactly up to rounding.
double linearHu(Vec3 p) {
  return 3 * p.x - 2 * p.y + 5 * p.z;
}

std::vector<std::int16_t> linearSlices(const SliceStack& stack, const std::vector<int>& order) {
  std::vector<std::int16_t> voxels;
  for (int n : order)
    for (int j = 0; j < stack.rows; ++j)
      for (int i = 0; i < stack.columns; ++i)
        voxels.push_back(static_cast<std::int16_t>(
            std::lround(linearHu(stack.positions_mm[n] + i * stack.spacing_mm[0] * stack.direction[0] +
                                 j * stack.spacing_mm[1] * stack.direction[1]))));
  return voxels;
}

class Tilt : public testing::TestWithParam<double> {};

TEST_P(Tilt, IsFoundFromPositionsAndUndone) {
  const double angle = GetParam() * std::numbers::pi / 180;
  SliceStack stack{60, 50, {1, 1}, {Vec3{1, 0, 0}, Vec3{0, std::cos(angle), std::sin(angle)}}, {}, 2};
  for (int n = 0; n < 12; ++n) stack.positions_mm.push_back({-30, -25, 100 + 2.5 * n});
  const StackPlan plan = planStack(stack);
  ASSERT_EQ(plan.refusal, "");
  EXPECT_TRUE(plan.resample);
  char expected[32];
  std::snprintf(expected, sizeof expected, "tilted by %.1f degrees", std::abs(GetParam()));
  EXPECT_THAT(plan.warnings, testing::ElementsAre(HasSubstr(expected)));
  EXPECT_TRUE(validate(plan.grid));

  const CtVolume ct = resampleStack(plan, stack, linearSlices(stack, plan.order));
  const Transform patientFromIndex = ct.geometry.patientFromIndex();
  int compared = 0;
  for (int k = 0; k < ct.geometry.size[2]; ++k)
    for (int j = 0; j < ct.geometry.size[1]; ++j)
      for (int i = 0; i < ct.geometry.size[0]; ++i) {
        if (ct.at(i, j, k) == -1024) continue;
        ++compared;
        ASSERT_NEAR(ct.at(i, j, k), linearHu(patientFromIndex * Vec3{double(i), double(j), double(k)}), 1.01);
      }
  EXPECT_GT(compared, 60 * 48 * 12) << "nearly every measured voxel is kept";
}

INSTANTIATE_TEST_SUITE_P(EitherSign, Tilt, testing::Values(-18.5, -3.0, 7.0, 25.0));

TEST(StackResample, RoundingCostsATiltedSliceNoEdge) {
  // Each slice lies one row further; their distance is no decimal number.
  constexpr int kSlices = 60;
  SliceStack stack{9, 12, {1, 1}, {Vec3{1, 0, 0}, Vec3{0, 1, 0}}, {}, 2};
  std::vector<std::int16_t> slices;
  for (int n = 0; n < kSlices; ++n) {
    stack.positions_mm.push_back({0, double(n), n * 7.0 / 3});
    slices.insert(slices.end(), std::size_t(stack.columns) * stack.rows, std::int16_t(100 + n));
  }
  const StackPlan plan = planStack(stack);
  ASSERT_EQ(plan.refusal, "");
  const CtVolume ct = resampleStack(plan, stack, slices);
  for (int k = 0; k < kSlices; ++k)
    for (int j = 0; j < ct.geometry.size[1]; ++j)
      EXPECT_EQ(ct.at(4, j, k), j >= k && j < k + stack.rows ? 100 + k : -1024) << "row " << j << " of slice " << k;
}

TEST(StackResample, GapIsFilledLinearly) {
  SliceStack stack = axialStack({0, 2.5, 7.5, 10});
  const StackPlan plan = planStack(stack);
  const CtVolume ct = resampleStack(plan, stack, linearSlices(stack, plan.order));
  ASSERT_EQ(ct.geometry.size[2], 5);
  const Transform patientFromIndex = ct.geometry.patientFromIndex();
  for (int k = 0; k < 5; ++k)
    EXPECT_NEAR(ct.at(7, 9, k), linearHu(patientFromIndex * Vec3{7, 9, double(k)}), 1.01) << "slice " << k;
}

TEST(StackResample, SidewaysJumpIsPutWhereItWasMeasured) {
  SliceStack stack = axialStack(ladder(6, 1));
  for (int n = 3; n < 6; ++n) stack.positions_mm[n].x += 4;
  const StackPlan plan = planStack(stack);
  ASSERT_EQ(plan.refusal, "");
  EXPECT_EQ(plan.grid.size[0], 32 + 8);
  const CtVolume ct = resampleStack(plan, stack, linearSlices(stack, plan.order));
  const Transform patientFromIndex = ct.geometry.patientFromIndex();
  EXPECT_EQ(ct.at(0, 5, 5), -1024) << "not measured there";
  for (int k = 0; k < 6; ++k)
    EXPECT_NEAR(ct.at(20, 5, k), linearHu(patientFromIndex * Vec3{20, 5, double(k)}), 1.01) << "slice " << k;
}

}  // namespace
}  // namespace insonate
