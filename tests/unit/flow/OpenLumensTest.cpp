#include <insonate/cases/Phantom.h>
#include <insonate/cases/TissueLabels.h>
#include <insonate/flow/BloodFlowModel.h>
#include <insonate/tissue/Labels.h>

#include <gtest/gtest.h>

#include <cmath>

namespace insonate {
namespace {

constexpr double kRadius_mm = 5;

/// A vein along +z in the middle of a block of tissue, in which labelAt(patient_mm) may replace the label of the lumen.
template <class LabelAt>
LabelMap veinWith(const LabelAt& labelAt) {
  VolumeGeometry grid;
  grid.size = {62, 62, 121}, grid.spacing_mm = {0.5, 0.5, 1}, grid.origin_mm = {-15.25, -15.25, -60};
  LabelMap labels(grid, kMuscle);
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) {
        const Vec3 at_mm = grid.origin_mm + Vec3{0.5 * i, 0.5 * j, double(k)};
        if (std::hypot(at_mm.x, at_mm.y) < kRadius_mm) labels.at(i, j, k) = labelAt(at_mm);
      }
  return labels;
}

NamedVessel partOf(const char* name, double from_mm, double to_mm) {
  NamedVessel vessel{name, kVein, {}};
  for (int i = 0; i <= 20; ++i) vessel.course.push_back({{0, 0, from_mm + (to_mm - from_mm) * i / 20}, kRadius_mm});
  return vessel;
}

/// Mean flows of the vessels with the label map, relative to those without.
std::vector<double> shares(const std::vector<NamedVessel>& vessels, const LabelMap& labels) {
  BloodFlowModel open(vessels), model(vessels, &labels);
  BloodFlow flow;
  open.at({}, {}, {}, flow), model.at({}, {}, {}, flow);
  std::vector<double> shares;
  for (std::size_t v = 0; v < vessels.size(); ++v)
    shares.push_back(model.volumeFlow(v).mean_mm3ps / open.volumeFlow(v).mean_mm3ps);
  return shares;
}

const auto kOpenLumen = [](Vec3) { return kVein; };

TEST(OpenLumens, AnOpenLumenLetsAllBloodPass) {
  const LabelMap labels = veinWith(kOpenLumen);
  EXPECT_DOUBLE_EQ(shares({partOf("right femoral vein", -55, 55)}, labels)[0], 1);
  // Center lines that leave the lumen at an end, or beside the middle of the lumen.
  EXPECT_DOUBLE_EQ(shares({partOf("right femoral vein", -90, 90)}, labels)[0], 1);
  NamedVessel beside = partOf("right femoral vein", -55, 55);
  for (NamedVessel::Point& point : beside.course) point.position_mm.x += 2;
  EXPECT_DOUBLE_EQ(shares({beside}, labels)[0], 1);
  const LabelMap ends = veinWith([](Vec3 p) { return p.z > 30 ? kMuscle : kVein; });
  EXPECT_DOUBLE_EQ(shares({partOf("right femoral vein", -55, 55)}, ends)[0], 1);
}

TEST(OpenLumens, CollateralsKeepTheirShareOfAFilledVein) {
  const LabelMap labels = veinWith([](Vec3 p) { return std::abs(p.z) < 12 ? kLymphNode : kVein; });
  const std::vector<NamedVessel> vessels{partOf("right femoral vein", -55, 55)};
  EXPECT_NEAR(shares(vessels, labels)[0], 0.15, 1e-9);
  BloodFlowModel open(vessels), filled(vessels, &labels);
  BloodFlow before, after;
  open.at({}, {}, {}, before), filled.at({}, {}, {}, after);
  for (const std::size_t point : {0, 10, 20})
    EXPECT_NEAR(after.tubes[0].course[point].scale, 0.15 * before.tubes[0].course[point].scale, 1e-9);
}

/// A quarter of the lumen is open: 1 / (1 + 0.02 (1 / a^2 - 1)) with a = (0.25 - 0.12) / (1 - 0.12).
TEST(OpenLumens, AVeinFilledToThreeQuartersIsAResistance) {
  const LabelMap labels =
      veinWith([](Vec3 p) { return std::abs(p.z) < 12 && (p.x > 0 || p.y > 0) ? kLymphNode : kVein; });
  const double a = (0.25 - 0.12) / 0.88, passes = 1 / (1 + 0.02 * (1 / (a * a) - 1));
  EXPECT_NEAR(shares({partOf("right femoral vein", -55, 55)}, labels)[0], 0.15 + 0.85 * passes, 0.03);
}

/// A thrombus is no part of a named vessel: the vein has two names, one on either side.
TEST(OpenLumens, AVeinWhoseContinuationIsFilledHasTheFlowOfCollaterals) {
  NamedVessel tributary{"right great saphenous vein", kVein, {}};
  for (int i = 0; i <= 10; ++i) tributary.course.push_back({{5.0 + i, 0, -2.0 - i}, 1.5});
  const std::vector<NamedVessel> vessels{partOf("right femoral vein", -55, -16),
                                         partOf("right common femoral vein", 16, 55), tributary};
  const std::vector<double> filled =
      shares(vessels, veinWith([](Vec3 p) { return std::abs(p.z) < 15 ? kLymphNode : kVein; }));
  EXPECT_NEAR(filled[0], 0.15, 1e-9);
  EXPECT_DOUBLE_EQ(filled[1], 1) << "the side of the heart";
  EXPECT_NEAR(filled[2], 0.15, 1e-9) << "joins the filled part";
  const std::vector<double> open = shares(vessels, veinWith(kOpenLumen));
  for (std::size_t v = 0; v < open.size(); ++v) EXPECT_DOUBLE_EQ(open[v], 1) << vessels[v].name;
}

TEST(OpenLumens, OnlyTheThrombusOfTheBuiltInCasesFillsALumen) {
  for (const char* name : {"textbook", "groin", "groin-thrombus", "axillary"}) {
    const auto patient = makePhantom(name, 1);
    ASSERT_TRUE(patient) << patient.error().message;
    const auto labels =
        withTissueLabels(patient->manifest.ownLabels, std::make_shared<const LabelMap>(patient->labels));
    const std::vector<double> passed = shares(patient->manifest.vessels, *labels);
    for (std::size_t v = 0; v < passed.size(); ++v) {
      const std::string& vessel = patient->manifest.vessels[v].name;
      const bool beyond = std::string(name) == "groin-thrombus" &&
                          (vessel == "right femoral vein" || vessel == "right deep femoral vein");
      if (beyond)
        EXPECT_NEAR(passed[v], 0.15, 1e-9) << vessel;
      else
        EXPECT_EQ(passed[v], 1) << name << ", " << vessel;
    }
  }
}

}  // namespace
}  // namespace insonate
