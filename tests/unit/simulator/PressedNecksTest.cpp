#include "support/NeckScene.h"
#include "support/TestData.h"

#include <insonate/cases/CaseFromLabels.h>
#include <insonate/cases/Import.h>
#include <insonate/cases/Phantom.h>
#include <insonate/cases/StartPose.h>
#include <insonate/cases/TissueLabels.h>
#include <insonate/segmentation/AutoLabel.h>
#include <insonate/simulator/CompressedTissue.h>
#include <insonate/simulator/Imager.h>
#include <insonate/simulator/ProbePlacement.h>
#include <insonate/simulator/ProbePose.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <random>

namespace insonate::test {
namespace {

/// A hand that goes anywhere on a patient, with any probe, and presses: whatever the anatomy is, the answer is finite
/// and one-to-one, more force goes further in, and released tissue is where it was.
class PressedNecks : public testing::Test {
 protected:
  static constexpr int kPlaces = 12;

  void pressAllOver(const PatientCase& patient) {
    const auto start = autoStartPose(patient);
    ASSERT_TRUE(start) << start.error().message;
    const auto pose = patientFromProbe(start->position_mm, start->axial, start->lateral);
    ASSERT_TRUE(pose);
    auto hand = ProbePlacement::make(patient.labels, *pose);
    ASSERT_TRUE(hand) << hand.error().message;
    const auto source = makeSceneSource(patient);
    ASSERT_TRUE(source) << source.error().message;
    const ProbePlacementState first = hand->state();
    for (place_ = 0; place_ < kPlaces; ++place_) {
      hand->restore(first);
      if (place_ > 0) goSomewhere(*hand);
      pressHere(**source, *hand);
    }
    std::printf("%d of %d not converged, %d stopped\n", notConverged_, asked_, stopped_);
    RecordProperty("asked", asked_);
    RecordProperty("not_converged", notConverged_);
    RecordProperty("stopped", stopped_);
    EXPECT_LT(notConverged_, asked_ / 7) << "of " << asked_;
  }

 private:
  void goSomewhere(ProbePlacement& hand) {
    hand.slide(uniform(-60, 60), uniform(-50, 50));
    hand.rotate(uniform(-180, 180));
    hand.tilt(uniform(-25, 25));
    hand.rock(uniform(-15, 15));
  }

  void pressHere(const SceneSource& source, ProbePlacement& hand) {
    static constexpr const char* kProbes[]{"linear", "linear", "curvilinear", "phased"};
    ImagingSetup setup;
    setup.probe = *loadProbe(kProbes[place_ % 4]);
    setup.settings = settingsFor(setup.probe);
    setup.tissues = *loadAcousticTable("neck");
    setup.mechanics.sticking = place_ % 5 == 4;
    const Transform touching = hand.pose();
    const auto scene = makeScene(source, setup, sceneRegion(setup, touching, 20));
    ASSERT_TRUE(scene) << scene.error().message;
    auto tissue = CompressedTissue::make(setup.probe, setup.settings, setup.mechanics);
    ASSERT_TRUE(tissue) << tissue.error().message;
    Physiology physiology{.centralVenous_mmHg = uniform(0, 12), .tilt_deg = uniform(-20, 20)};
    const BloodPressure pressure = bloodPressure(physiology, setup.mechanics.tissues, uniform(0, 60));

    // A hand that is held has no force that would stop it: bone stands still, and no answer is right behind its skin.
    const auto travel = tissue->travelRange(**scene, touching);
    ASSERT_TRUE(travel) << where();
    // On hollow skin, under a jaw or above a collar bone, the ends of the face lie deep in it before it is pressed.
    const bool sits = travel->touch_mm > -4;
    for (const double by_mm : {2.0, 2.0, 3.0, -4.0}) {
      hand.press(by_mm);
      const double in_mm = norm(hand.pose().offset - touching.offset);
      tissue->hold(**scene, hand.pose(), pressure);
      expectSane(*tissue, "held", sits && in_mm < 0.7 * travel->deepest_mm);
    }
    double min_mm = 0;
    for (const double force_N : {0.3, 1.0, 2.0, 4.0}) {
      tissue->push(**scene, touching, pressure, force_N);
      expectSane(*tissue, "pushed", sits);
      stopped_ += tissue->isStopped();
      if (!tissue->deformation().converged || tissue->isStopped()) break;
      EXPECT_NEAR(tissue->deformation().force_N, force_N, 0.05 * force_N + 0.01) << where();
      if (force_N == 0.3) min_mm = tissue->indentation_mm();
      // Not at every step: tissue that buckles gives way more than one way.
      if (force_N == 4) {
        EXPECT_GT(tissue->indentation_mm(), min_mm) << where();
      }
    }
    hand.lift();
    tissue->hold(**scene, hand.pose(), bloodPressure({}, setup.mechanics.tissues));
    if (tissue->indentation_mm() <= 0) {
      EXPECT_TRUE(tissue->deformation().displacement.empty()) << where() << ": lifted off";
    }
  }

  void expectSane(const CompressedTissue& tissue, const char* how, bool within) {
    const Deformation& d = tissue.deformation();
    asked_ += within;
    notConverged_ += within && !d.converged;
    ASSERT_TRUE(std::isfinite(d.force_N) && d.force_N >= 0) << where() << how << d.force_N;
    // On its way to an answer, a large force is told nobody (LiveDeformation::settled).
    ASSERT_LT(within && d.converged ? d.force_N : 0, 100) << where() << how << ' ' << tissue.indentation_mm();
    for (const LumenArea& lumen : d.lumens) {
      ASSERT_TRUE(std::isfinite(lumen.area_mm2) && lumen.area_mm2 >= 0) << where() << how;
      // 12 mmHg and head down double a vein; an artery under pulse pressure widens by some per cent.
      const double most = lumen.label == kArtery ? 1.3 : 4;
      ASSERT_LT(lumen.area_mm2, most * lumen.rest_mm2 + 5)
          << where() << how << ", converged: " << d.converged << ", within: " << within << ", label "
          << int(lumen.label) << ", rest " << lumen.rest_mm2;
    }
    if (d.displacement.empty()) return;
    const Folds folds = foldsOf(d.displacement);
    EXPECT_EQ(folds.notFinite, 0) << where() << how;
    EXPECT_EQ(folds.folded, 0) << where() << how;
  }

  std::string where() const { return "place " + std::to_string(place_) + ' '; }
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

  std::mt19937 random_{23};
  int place_ = 0, asked_ = 0, notConverged_ = 0, stopped_ = 0;
};

class PressedVariants : public PressedNecks, public testing::WithParamInterface<int> {};

TEST_P(PressedVariants, GiveWayAnywhere) {
  auto patient = makePhantom(phantomVariants()[GetParam()].name, 1);
  ASSERT_TRUE(patient) << patient.error().message;
  replaceOwnLabels(*patient);
  pressAllOver(*patient);
}
INSTANTIATE_TEST_SUITE_P(Phantom, PressedVariants, testing::Range(0, int(phantomVariants().size())),
                         [](const auto& at) {
                           std::string name(phantomVariants()[at.param].name);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST_F(PressedNecks, OfTheAtlas) {
  INSONATE_NEEDS_DATA("neck-atlas-labels/HN-Atlas-labels.nrrd");
  const auto made =
      caseFromLabels(testData("neck-atlas-labels/HN-Atlas-labels.nrrd"),
                     std::filesystem::path(INSONATE_SOURCE_DIR) / "resources/maps/spl-head-neck.json", {});
  ASSERT_TRUE(made) << made.error().message;
  pressAllOver(made->patient);
}

TEST_F(PressedNecks, OfARealCt) {
  INSONATE_NEEDS_DATA("neck-ct-dicom");
  auto imported = importSeries(testData("neck-ct-dicom"));
  ASSERT_TRUE(imported) << imported.error().message;
  auto labels = autoLabel(imported->ct, {});
  ASSERT_TRUE(labels) << labels.error().message;
  pressAllOver({{}, std::move(imported->ct), std::move(*labels)});
}

}  // namespace
}  // namespace insonate::test
