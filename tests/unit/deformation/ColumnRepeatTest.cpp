#include "ColumnRig.h"
#include "support/Allocations.h"

#include <gmock/gmock.h>

namespace insonate::test {
namespace {

class ColumnRepeat : public ColumnRig {
 protected:
  void SetUp() override {
    plane.press_mm = 5;
    plane.circles = {{-4, 15, 4, kVein}, {8, 20, 3, kArtery}};
  }
  std::unique_ptr<DeformationModel> model = *makeDeformationModel("column", tissues, settings);
};

TEST_F(ColumnRepeat, TheSameQuestionHasTheSameAnswer) {
  Deformation first, again;
  DeformationInput input;
  input.plane = &plane;
  input.face = face;
  model->solve(input, first);
  plane.press_mm = 9;
  model->solve(input, again);  // another question between
  plane.press_mm = 5;
  model->solve(input, again);
  EXPECT_EQ(again.force_N, first.force_N);
  ASSERT_EQ(again.displacement.restFromDisplayed.size(), first.displacement.restFromDisplayed.size());
  for (std::size_t i = 0; i < first.displacement.restFromDisplayed.size(); ++i)
    ASSERT_EQ(again.displacement.restFromDisplayed[i].z_mm, first.displacement.restFromDisplayed[i].z_mm);
}

TEST_F(ColumnRepeat, ReleaseLeavesNothingBehind) {
  Deformation answer;
  DeformationInput input;
  input.plane = &plane;
  input.face = face;
  model->solve(input, answer);
  EXPECT_TRUE(answer.moved);
  plane.press_mm = -1;
  model->solve(input, answer);
  EXPECT_FALSE(answer.moved);
  EXPECT_TRUE(answer.displacement.empty());
  EXPECT_TRUE(answer.lumens.empty());
  EXPECT_EQ(answer.force_N, 0);
}

TEST_F(ColumnRepeat, ALaterQuestionAllocatesNothing) {
  Deformation answer;
  DeformationInput input;
  input.plane = &plane;
  input.face = face;
  model->solve(input, answer);
  const long before = allocations();
  plane.press_mm = 7.7;
  model->solve(input, answer);
  input.force_N = 3;
  model->solve(input, answer);
  plane.press_mm = -50;
  input.force_N = 0;
  model->solve(input, answer);
  EXPECT_EQ(allocations() - before, 0);
}

}  // namespace
}  // namespace insonate::test
