#include <insonate/deformation/DeformationModel.h>

#include <gmock/gmock.h>

#include <limits>

namespace insonate {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string refusalOf(std::string_view name, const DeformationSettings& settings = {}) {
  const auto model = makeDeformationModel(name, MechanicalTable{}, settings);
  EXPECT_FALSE(model);
  return model ? "" : model.error().message;
}

TEST(ModelRegistry, EveryNameMakesAModelOfThatName) {
  for (const std::string& name : deformationModelNames()) {
    const auto model = makeDeformationModel(name, MechanicalTable{});
    ASSERT_TRUE(model) << model.error().message;
    EXPECT_EQ((*model)->name(), name);
  }
}

TEST(ModelRegistry, AnUnknownNameIsRefused) {
  EXPECT_THAT(refusalOf("rubber"), HasSubstr("'rubber'"));
}

TEST(ModelRegistry, SettingsOutOfRangeAreRefusedWithFieldValueAndRange) {
  EXPECT_THAT(refusalOf("column", {.mesh_mm = 0.05}),
              AllOf(HasSubstr("mesh_mm"), HasSubstr("0.05"), HasSubstr("0.1 to 4")));
  EXPECT_THAT(refusalOf("column", {.depth_mm = 500}),
              AllOf(HasSubstr("depth_mm"), HasSubstr("500"), HasSubstr("10 to 200")));
  EXPECT_THAT(refusalOf("column", {.tolerance_mm = -1}), HasSubstr("tolerance_mm"));
  EXPECT_THAT(refusalOf("column", {.mesh_mm = std::numeric_limits<double>::quiet_NaN()}), HasSubstr("mesh_mm"));
}

}  // namespace
}  // namespace insonate
