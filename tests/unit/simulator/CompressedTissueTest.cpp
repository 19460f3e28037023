#include "support/SmallCase.h"
#include "support/TestData.h"

#include <insonate/deformation/FaceProfile.h>
#include <insonate/simulator/CompressedTissue.h>
#include <insonate/simulator/DisplacementFile.h>
#include <insonate/simulator/Imager.h>
#include <insonate/simulator/ProbePose.h>

#include <gmock/gmock.h>

#include <cstring>

namespace insonate {
namespace {

using testing::HasSubstr;

/// The small block: skin at y = -0.5 mm, a vein of 5 mm at 12 mm, bone from 25.5 mm on.
class PressedBlock : public testing::Test {
 protected:
  static constexpr double kSkin_mm = -0.5, kBone_mm = 25.5;

  void SetUp() override {
    setup_.probe = *loadProbe("linear");
    setup_.probe.width_mm = 20;
    setup_.settings = settingsFor(setup_.probe);
    setup_.settings.depth_mm = 30;
    setup_.tissues = *loadAcousticTable("neck");
    setup_.mechanics.settings.mesh_mm = 1;
    patient_ = test::smallCase();
  }
  static Transform at(double y_mm) { return *patientFromProbe({0, y_mm, 0}, {0, 1, 0}, {1, 0, 0}); }
  std::shared_ptr<const AcousticScene> scene(const Transform& pose) const {
    return makeScene(patient_, setup_, sceneRegion(setup_, pose, 20)).value();
  }
  CompressedTissue tissue() const {
    return std::move(CompressedTissue::make(setup_.probe, setup_.settings, setup_.mechanics).value());
  }
  BloodPressure mean() const { return bloodPressure({}, setup_.mechanics.tissues); }

  ImagingSetup setup_;
  PatientCase patient_;
};

/// Rest position in the patient of tissue that is seen at a point of a pose's plane.
Vec3 restOf(const PlaneDisplacement& d, const Transform& pose, double x_mm, double z_mm) {
  const double c = std::clamp((x_mm - d.left_mm) / d.step_mm, 0.0, d.columns - 1.001);
  const double r = std::clamp((z_mm - d.top_mm) / d.step_mm, 0.0, d.rows - 1.001);
  const int i = static_cast<int>(c), j = static_cast<int>(r);
  const auto shift = [&](int a, int b) { return d.restFromDisplayed[std::size_t(j + b) * d.columns + i + a]; };
  const double u = c - i, v = r - j;
  const auto blend = [&](auto of) {
    return (1 - v) * ((1 - u) * of(shift(0, 0)) + u * of(shift(1, 0))) +
           v * ((1 - u) * of(shift(0, 1)) + u * of(shift(1, 1)));
  };
  return pose * Vec3{x_mm + blend([](auto s) { return double(s.x_mm); }), 0,
                     z_mm + blend([](auto s) { return double(s.z_mm); })};
}

TEST_F(PressedBlock, TravelIsFromSkinToBone) {
  CompressedTissue pressed = tissue();
  for (const double y_mm : {-8.0, -0.5, 3.0, 9.0}) {
    const auto travel = pressed.travelRange(*scene(at(y_mm)), at(y_mm));
    ASSERT_TRUE(travel) << y_mm;
    EXPECT_NEAR(travel->touch_mm, kSkin_mm - y_mm, 0.2) << y_mm;
    EXPECT_NEAR(travel->deepest_mm, kSkin_mm + 0.9 * (kBone_mm - kSkin_mm) - y_mm, 0.6) << y_mm;
  }
}

TEST_F(PressedBlock, AForceIsTheIndentationThatItGives) {
  const auto block = scene(at(-3));
  CompressedTissue pushed = tissue(), held = tissue();
  pushed.push(*block, at(-3), mean(), 0.5);
  ASSERT_TRUE(pushed.deformation().converged);
  EXPECT_NEAR(pushed.deformation().force_N, 0.5, 0.01);
  EXPECT_GT(pushed.indentation_mm(), 1);
  EXPECT_NEAR(pushed.pose().offset.y, kSkin_mm + pushed.indentation_mm(), 0.2);
  held.hold(*block, pushed.pose(), mean());
  EXPECT_NEAR(held.deformation().force_N, 0.5, 0.05);
  EXPECT_NEAR(held.indentation_mm(), pushed.indentation_mm(), 0.1);
  // The two frames are one: the same tissue is seen at the same place, and the skin lies on the face.
  const Transform& pose = pushed.pose();
  for (const double x_mm : {-6.0, 0.0, 4.0})
    for (const double z_mm : {0.5, 6.0, 14.0, 20.0}) {
      const Vec3 a = restOf(pushed.deformation().displacement, pose, x_mm, z_mm);
      const Vec3 b = restOf(held.deformation().displacement, pose, x_mm, z_mm);
      EXPECT_NEAR(norm(a - b), 0, 0.25) << x_mm << ' ' << z_mm;
    }
  EXPECT_NEAR(restOf(pushed.deformation().displacement, pose, 0, 0.0).y, kSkin_mm, 0.3);
  for (const MeshNode& node : pushed.deformation().mesh)
    EXPECT_TRUE(std::abs(node.x_mm) > 9 || node.z_mm > -0.3) << "no tissue above the face";
}

TEST_F(PressedBlock, WhereAPushBeginsDoesNotMatter) {
  CompressedTissue near = tissue(), far = tissue();
  near.push(*scene(at(0)), at(0), mean(), 0.4);
  far.push(*scene(at(-9)), at(-9), mean(), 0.4);
  EXPECT_NEAR(near.pose().offset.y, far.pose().offset.y, 0.1);
  EXPECT_NEAR(near.indentation_mm(), far.indentation_mm(), 0.1);
}

TEST_F(PressedBlock, NoForceIsNoPressureWhereverTheFaceIs) {
  CompressedTissue pressed = tissue();
  pressed.push(*scene(at(4)), at(4), mean(), 0);
  EXPECT_TRUE(pressed.deformation().displacement.empty());
  EXPECT_EQ(pressed.pose(), at(4));
  pressed.hold(*scene(at(4)), at(4), mean());
  EXPECT_FALSE(pressed.deformation().displacement.empty());
  pressed.hold(*scene(at(-2)), at(-2), mean());
  EXPECT_TRUE(pressed.deformation().displacement.empty());
  EXPECT_NEAR(pressed.indentation_mm(), -1.5, 0.2);
}

TEST_F(PressedBlock, BoneStopsTheFace) {
  CompressedTissue pressed = tissue();
  pressed.push(*scene(at(-1)), at(-1), mean(), 45);
  EXPECT_LT(pressed.pose().offset.y, kBone_mm);
  EXPECT_TRUE(pressed.isStopped());
  for (const auto& shift : pressed.deformation().displacement.restFromDisplayed)
    ASSERT_TRUE(std::isfinite(shift.x_mm) && std::isfinite(shift.z_mm));
}

TEST_F(PressedBlock, AnswersDoNotDependOnTheSceneAroundThem) {
  CompressedTissue small = tissue(), large = tissue();
  small.hold(*scene(at(3)), at(3), mean());
  Region wide = sceneRegion(setup_, at(3), 20);
  wide.low_mm = wide.low_mm - Vec3{15, 9, 5}, wide.high_mm = wide.high_mm + Vec3{11, 3, 8};
  large.hold(*makeScene(patient_, setup_, wide).value(), at(3), mean());
  EXPECT_NEAR(small.deformation().force_N, large.deformation().force_N, 0.01 * small.deformation().force_N);
  ASSERT_EQ(small.deformation().lumens.size(), large.deformation().lumens.size());
  EXPECT_NEAR(small.deformation().lumens[0].area_mm2, large.deformation().lumens[0].area_mm2, 0.3);
}

/// The figures of the GE 12L-RS: a field of 38 mm in a face of 42 mm, in a housing of 47 mm with its rounded ends.
TEST(FaceOf, IsThatOfTheHousing) {
  const TissueMechanics mechanics;
  const ProbeFace linear = probeFaceOf(*loadProbe("linear"), mechanics);
  EXPECT_EQ(linear.width_mm, 42);
  EXPECT_EQ(linear.radius_mm, 0);
  EXPECT_NEAR(2 * FaceProfile(linear).reach_mm(), 47, 0.5);
  const ProbeFace curved = probeFaceOf(*loadProbe("curvilinear"), mechanics);
  EXPECT_EQ(curved.radius_mm, 50);
  EXPECT_NEAR(curved.width_mm, 2 * 50 * 0.57060, 0.01);  // sin(32.5 degrees + 2/50 rad)
  EXPECT_NEAR(probeFaceOf(*loadProbe("phased"), mechanics).width_mm, 22.4, 1e-9);
}

/// At the end of a face, the skin rises steeply. That must happen beside the image.
TEST_F(PressedBlock, TheSkinLiesOnTheFaceBesideTheArray) {
  CompressedTissue pressed = tissue();
  pressed.hold(*scene(at(3)), at(3), mean());
  int beside = 0;
  for (int i = 0; i < pressed.deformation().meshColumns; ++i) {
    const MeshNode& skin = pressed.deformation().mesh[i];
    if (std::abs(skin.x_mm) > setup_.probe.width_mm / 2 + 1.5) continue;
    EXPECT_NEAR(skin.z_mm, 0, 0.1) << skin.x_mm;
    beside += std::abs(skin.x_mm) > setup_.probe.width_mm / 2 + 0.5;
  }
  EXPECT_GE(beside, 2);
}

TEST(BloodPressureOf, AtRestIsExactlyThatOfTheCt) {
  const BloodPressure rest = bloodPressure({}, measuredMechanics());
  EXPECT_EQ(rest.artery_kPa, measuredMechanics().of(kArtery).pressure_kPa);
  EXPECT_EQ(rest.vein_kPa, measuredMechanics().of(kVein).pressure_kPa);
  EXPECT_GT(bloodPressure({.tilt_deg = 15}, measuredMechanics()).vein_kPa, rest.vein_kPa);
}

TEST(DisplacementFile, IsAVectorVolumeInPatientSpace) {
  const test::TemporaryFolder folder;
  const PlaneDisplacement field{.left_mm = -1,
                                .top_mm = -2,
                                .step_mm = 0.5,
                                .columns = 2,
                                .rows = 1,
                                .restFromDisplayed = {{1, 2}, {0, -3}},
                                .lung = {}};
  // Lateral to the left (+x), axial to the back (+y): columns run along x, rows along y.
  const Transform pose = *patientFromProbe({10, 20, 30}, {0, 1, 0}, {1, 0, 0});
  ASSERT_TRUE(writeDisplacement(field, pose, folder / "u.nrrd"));
  const std::string bytes = test::bytesOf(folder / "u.nrrd");
  EXPECT_THAT(bytes, HasSubstr("space: left-posterior-superior"));
  EXPECT_THAT(bytes, HasSubstr("sizes: 3 2 1 1"));
  EXPECT_THAT(bytes, HasSubstr("space directions: none (0.5,0,0) (0,0.5,0) (0,0,0.5)"));
  EXPECT_THAT(bytes, HasSubstr("space origin: (9,18,30)"));
  float values[6];
  ASSERT_EQ(bytes.size() - bytes.find("\n\n") - 2, sizeof values);
  std::memcpy(values, bytes.data() + bytes.size() - sizeof values, sizeof values);
  EXPECT_THAT(values, testing::ElementsAre(1, 2, 0, 0, -3, 0));
  EXPECT_FALSE(writeDisplacement({}, pose, folder / "v.nrrd"));
}

}  // namespace
}  // namespace insonate
