#include "GuideWindow.h"

#include <insonate/cases/Phantom.h>
#include <insonate/segmentation/AutoLabel.h>

#include <integration/CommandLine.h>

#include <QElapsedTimer>

namespace insonate::prepare {
namespace {

/// The built-in neck as it comes from a hospital: its CT, and what an import labels of it.
class GuidingANeck : public Guiding {
 protected:
  static std::shared_ptr<const PatientCase> neck() {
    static const auto made = [] {
      auto patient = std::make_shared<PatientCase>(*makePhantom("textbook", 1, {}, CtContrast::kArterial));
      patient->manifest.startPoses.clear(), patient->manifest.targets.clear(), patient->manifest.vessels.clear();
      patient->labels = LabelMap(patient->ct.geometry);
      return patient;
    }();
    return made;
  }
  std::shared_ptr<const PatientCase> imported() {
    auto patient = std::make_shared<PatientCase>(*neck());
    patient->labels = *autoLabel(patient->ct, {});
    return patient;
  }
};

TEST_F(GuidingANeck, TheAutomaticStepRunsAndIsCancelledWithinASecond) {
  openCase(neck());
  EXPECT_EQ(guide_->step().name, "automatic");
  auto* run = child<QPushButton>("guideRun");
  run->click();
  EXPECT_EQ(guide_->state(0), State::Working);
  EXPECT_EQ(run->text(), "Cancel");
  EXPECT_TRUE(tasks_.isRunning());
  QTest::qWait(150);
  QElapsedTimer clock;
  clock.start();
  run->click();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !guide_->isBusy(); }, 1000));
  std::printf("cancelled after %lld ms\n", static_cast<long long>(clock.elapsed()));
  EXPECT_EQ(guide_->state(0), State::ToDo);
  EXPECT_EQ(voxels(), neck()->labels.voxels) << "as before";

  this->run();
  EXPECT_EQ(guide_->state(0), State::Done) << guide_->remarks(0).join(' ').toStdString();
  EXPECT_EQ(voxels(), autoLabel(neck()->ct, {})->voxels);
  // The list of structures of this case says so from the beginning.
  EXPECT_EQ(child<QTreeWidget>("guideSteps")->topLevelItem(0)->text(1), "completed");
  child<QPushButton>("guideAccept")->click();
  EXPECT_EQ(child<QTreeWidget>("guideSteps")->topLevelItem(0)->text(1), "completed");
  EXPECT_EQ(guide_->step().name, "vein-right");
}

TEST_F(GuidingANeck, WhatTheImportHasLabeledIsDoneAlready) {
  openCase(imported());
  EXPECT_EQ(guide_->state(0), State::Done);
  EXPECT_EQ(guide_->step().name, "vein-right") << "the first thing to do";
  choose("automatic");
  EXPECT_THAT(child<QLabel>("guideResult")->text().toStdString(), HasSubstr("already"));
  run();
  EXPECT_EQ(guide_->state(0), State::Done) << "it comes to the same";
  EXPECT_THAT(child<QLabel>("guideTold")->text().toStdString(), testing::Not(HasSubstr("clicks")));
}

TEST_F(GuidingANeck, ABareImportAfterALabeledCaseBeginsAtTheFirstStep) {
  openCase(imported());
  ASSERT_EQ(guide_->step().name, "vein-right");
  openCase(neck());
  EXPECT_EQ(guide_->step().name, "automatic");
  EXPECT_EQ(guide_->state(0), State::ToDo);
}

TEST_F(GuidingANeck, DoneThroughTheWindowItReplaysByTheCommandToEveryVoxel) {
  const test::TemporaryFolder folder;
  const auto begun = imported();
  ASSERT_TRUE(writeCase(*begun, folder.path() / "imported"));
  openCase(begun);
  // The vessels of the textbook neck.
  const auto whole = makePhantom("textbook", 1, {}, CtContrast::kArterial);
  const auto middleAt = [&](std::string_view vessel, double z_mm) {
    const auto& course = std::ranges::find(whole->manifest.vessels, vessel, &NamedVessel::name)->course;
    return std::ranges::min(course, {}, [&](const auto& at) { return std::abs(at.position_mm.z - z_mm); }).position_mm;
  };
  constexpr std::string_view kJugular = "right internal jugular vein", kCarotid = "right common carotid artery";
  const Vec3 target_mm = whole->manifest.targets.front().position_mm;
  for (const auto& [step, label, vessel] :
       {std::tuple{"vein-right", kVein, kJugular}, {"artery-right", kArtery, kCarotid}}) {
    choose(step);
    for (const double z : {-12.0, 0.0, 12.0}) click(middleAt(vessel, target_mm.z + z));
    run();
    EXPECT_GT(count(label), 200u) << step << ": " << child<QLabel>("guideTold")->text().toStdString();
  }
  const auto named = [](const std::vector<NamedVessel>& vessels) {
    std::vector<std::string> names;
    for (const NamedVessel& vessel : vessels) names.push_back(vessel.name);
    return names;
  };
  for (const auto* step : {"vein-right", "artery-right"}) {
    choose(step);
    const std::size_t before = shared_->places.value().vessels.size();
    child<QPushButton>("guideAccept")->click();
    EXPECT_TRUE(QTest::qWaitFor([&] { return shared_->places.value().vessels.size() > before; }, kPatience_ms)) << step;
  }
  EXPECT_THAT(named(shared_->places.value().vessels),
              testing::ElementsAre("right internal jugular vein", "right common carotid artery"));
  choose("vein-right");
  child<QPushButton>("guideCorrect")->click();
  drag(middleAt(kJugular, target_mm.z), middleAt(kJugular, target_mm.z) + Vec3{-6, 0, 0});
  choose("automatic");
  run();  // all that was made after it is made again
  EXPECT_EQ(shared_->labeling.recipe().steps.size(), 3u) << "the CT tells what is there already";
  save(folder.path() / "made");

  ASSERT_TRUE(readCase(folder.path() / "made"));
  const auto path = [&](const char* name) { return test::shellWord((folder.path() / name).string()); };
  const auto command =
      test::runCommand("label " + path("imported") + " " + path("made/recipe.json") + " --out " + path("replayed"),
                       (folder.path() / "errors").string());
  ASSERT_EQ(command.status, 0) << command.errors;
  const auto made = readCase(folder.path() / "made"), replayed = readCase(folder.path() / "replayed");
  ASSERT_TRUE(made && replayed);
  EXPECT_TRUE(made->patient.labels.voxels == replayed->patient.labels.voxels) << "every voxel";
  EXPECT_GT(std::ranges::count(made->patient.labels.voxels, std::uint8_t{kVein}), 200);
  EXPECT_EQ(named(made->patient.manifest.vessels), named(replayed->patient.manifest.vessels));
  EXPECT_EQ(made->patient.manifest.vessels.size(), 2u);
}

}  // namespace
}  // namespace insonate::prepare
