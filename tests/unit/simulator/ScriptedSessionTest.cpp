#include "support/SmallCase.h"
#include "support/TestData.h"

#include <insonate/procedure/AttemptRecording.h>
#include <insonate/simulator/AttemptSettings.h>
#include <insonate/simulator/ScriptedSession.h>

#include <gmock/gmock.h>

namespace insonate {
namespace {

using testing::HasSubstr;

/// Scripts on the small block. Its voxels of skin begin at y = 0 and those of the vein, below x = 0, at 8 and end at
/// 16, so that the surfaces between them lie at -0.5, 7.5 and 16.5: d1 is 8 mm and the back wall 17 mm below the skin.
/// A wall bends before it gives, so that the tip is deeper than the hole when it does.
class ScriptedSession : public testing::Test {
 protected:
  SessionOutcome run(const std::string& actions, const std::string& more = "") {
    const auto script = readSessionScript("{" + more + "\"acts\": [" + actions + "]}", patient);
    EXPECT_TRUE(script) << script.error().message;
    file = folder / ("attempt-" + std::to_string(++runs_));
    auto outcome = runSession(*script, patient, "insonate test", file, {});
    if (!outcome) throw std::runtime_error(outcome.error().message);
    return std::move(*outcome);
  }
  static std::string straight(double x_mm = 0) {
    const std::string x = std::to_string(x_mm);
    return "{\"probe\": \"auto\"}, {\"needle\": {\"from_mm\": [" + x + ", -5, 0], \"to\": [" + x + ", 12, 0]}}";
  }
  /// Without those of finding the vein.
  static std::vector<AttemptEvent> needleEvents(const SessionOutcome& outcome) {
    std::vector<AttemptEvent> events;
    std::ranges::copy_if(outcome.events, std::back_inserter(events),
                         [](const AttemptEvent& event) { return event.kind < AttemptEventKind::Centered; });
    return events;
  }
  static std::ptrdiff_t countOf(const SessionOutcome& outcome, AttemptEventKind kind) {
    return std::ranges::count(outcome.events, kind, &AttemptEvent::kind);
  }
  static std::vector<std::string> told(const SessionOutcome& outcome) {
    static const char* const kNames[]{"entered", "left", "withdrawn", "struck", "new", "frozen", "released", "tilt"};
    std::vector<std::string> names;
    for (const AttemptEvent& event : needleEvents(outcome))
      names.push_back(std::string(kNames[static_cast<int>(event.kind)]) +
                      (event.kind <= AttemptEventKind::Struck ? " " + std::string(labelTable()[event.wall].name) : ""));
    return names;
  }

  PatientCase patient = test::smallAttemptCase();
  const test::TemporaryFolder folder;
  std::filesystem::path file;

 private:
  int runs_ = 0;
};

/// 5 mm to the skin and 12 mm on, at 10 mm/s.
TEST_F(ScriptedSession, CleanSuccess) {
  const auto outcome = run(straight() + R"(, {"aspirate": true}, {"advance_mm": 17}, {"wait_s": 1.5})");
  EXPECT_THAT(told(outcome), testing::ElementsAre("entered skin", "entered vein"));
  EXPECT_NEAR(needleEvents(outcome)[1].depth_mm, 8, 0.3);
  const MetricValues& metrics = outcome.metrics;
  EXPECT_EQ(metrics[Metric::VeinPunctures], 1);
  EXPECT_EQ(metrics[Metric::PosteriorWallPunctures], 0);
  EXPECT_EQ(metrics[Metric::TipInVein], 1);
  EXPECT_THAT(metrics[Metric::AttemptTime], testing::Optional(testing::DoubleNear(3.2, 0.01)));
  EXPECT_GT(*metrics[Metric::TimeToVein], 0.1);
  EXPECT_LT(*metrics[Metric::TimeToVein], 1.2);
  EXPECT_NEAR(*metrics[Metric::InsertionAngle], 90, 3);
  EXPECT_NEAR(*metrics[Metric::AspirationWhileAdvancing], 100, 1e-9);
  EXPECT_LT(*metrics[Metric::VeinCenterDistance], 0.5) << "it stops at the vein's middle, 12 mm deep, pressed a little";
  // From x = 0 to the artery's wall at x = -17.5, less what the probe presses.
  EXPECT_NEAR(*metrics[Metric::NearestArtery], 17.5, 0.1);
  EXPECT_EQ(metrics[Metric::NearestLung], std::nullopt) << "the block has none";
  EXPECT_TRUE(outcome.run.succeeded());
}

TEST_F(ScriptedSession, TheRecordingSaysThatAScriptMovedTheHands) {
  run(straight() + R"(, {"advance_mm": 5})");
  const auto recording = AttemptRecording::open(file);
  ASSERT_TRUE(recording) << recording.error().message;
  EXPECT_TRUE(recording->header().isScripted);
}

TEST_F(ScriptedSession, PosteriorWallAndOutAgain) {
  const auto outcome = run(straight() + R"(, {"advance_mm": 27}, {"withdraw_mm": 27})");
  EXPECT_THAT(told(outcome), testing::ElementsAre("entered skin", "entered vein", "left vein", "withdrawn vein",
                                                  "withdrawn vein", "withdrawn skin"));
  EXPECT_NEAR(needleEvents(outcome)[2].depth_mm, 17, 0.3);
  EXPECT_EQ(outcome.metrics[Metric::PosteriorWallPunctures], 1);
  EXPECT_EQ(outcome.metrics[Metric::TipInVein], 0);
  EXPECT_FALSE(outcome.run.succeeded());
}

/// A second vein, 17 mm beside the first, is the target now.
TEST_F(ScriptedSession, AnotherVeinThanTheTargetIsNoSuccess) {
  LabelMap& labels = patient.labels;
  for (int k = 0; k < labels.geometry.size[2]; ++k)
    for (int j = 15; j < 22; ++j)
      for (int i = 38; i < 45; ++i) labels.at(i, j, k) = kVein;
  patient.manifest.targets = {{"right internal jugular vein", kVein, {17, 12, 0}}};
  const std::string inAndAspirate = R"(, {"aspirate": true}, {"advance_mm": 17}, {"wait_s": 1.5})";

  const auto wrong = run(straight() + inAndAspirate);
  EXPECT_THAT(told(wrong), testing::ElementsAre("entered skin", "entered vein"));
  EXPECT_EQ(needleEvents(wrong)[1].vessel, kUnnamedVessel);
  EXPECT_EQ(wrong.metrics[Metric::VeinPunctures], 0);
  EXPECT_EQ(wrong.metrics[Metric::OtherVeinPunctures], 1);
  EXPECT_FALSE(wrong.run.succeeded());
  const auto kept = AttemptRecording::open(file);
  ASSERT_TRUE(kept) << kept.error().message;
  EXPECT_THAT(kept->header().vessels, testing::ElementsAre("right internal jugular vein"));
  EXPECT_EQ(*kept->metricsUntil(), wrong.metrics) << "a replay tells the same";

  const auto right = run(straight(17) + inAndAspirate);
  EXPECT_EQ(needleEvents(right)[1].vessel, 1);
  EXPECT_EQ(right.metrics[Metric::VeinPunctures], 1);
  EXPECT_EQ(right.metrics[Metric::OtherVeinPunctures], 0);
  EXPECT_TRUE(right.run.succeeded());
}

/// A probe that rests on the skin has found nothing, and one beside the vein neither.
TEST_F(ScriptedSession, TheVeinIsFoundByCenteringAndCompressingIt) {
  using enum AttemptEventKind;
  const std::string press = R"(, {"wait_s": 1.2}, {"move_probe_mm": [0, 0, 7]}, {"wait_s": 0.3})";
  const auto rests = run(R"({"probe": "auto"}, {"wait_s": 3})");
  EXPECT_EQ(countOf(rests, Centered), 1);
  EXPECT_EQ(countOf(rests, Compressed), 0);
  EXPECT_EQ(rests.metrics[Metric::VeinChecks], 0);

  const auto beside = run(R"({"probe": "auto"}, {"move_probe_mm": [9, 0, 0]})" + press);
  EXPECT_EQ(countOf(beside, Centered) + countOf(beside, Compressed), 0);

  const auto found = run(R"({"probe": "auto"})" + press);
  EXPECT_EQ(countOf(found, Compressed), 1);
  EXPECT_EQ(found.metrics[Metric::VeinChecks], 1);
  const auto compressed = std::ranges::find(found.events, Compressed, &AttemptEvent::kind);
  EXPECT_EQ(compressed->vessel, 1);
  EXPECT_NEAR(compressed->tip_mm.y, 12, 2) << "the middle of the vein";
  const auto scan = std::ranges::find(found.run.procedure().steps, "scan", &ProcedureStep::name);
  const auto step = static_cast<std::size_t>(scan - found.run.procedure().steps.begin());
  EXPECT_EQ(found.run.steps()[step].state, ProcedureRun::StepState::Done);
  EXPECT_EQ(rests.run.steps()[step].state, ProcedureRun::StepState::Open);
}

/// In the groin, head-down tilt empties the vein.
TEST_F(ScriptedSession, TheTiltActsAtTheSiteOfTheCase) {
  const auto vein_kPa = [this](const std::string& procedure) {
    run(R"({"probe": "auto"}, {"wait_s": 0.1}, {"tilt_deg": 5}, {"wait_s": 0.1})",
        R"("procedure": ")" + procedure + R"(", )");
    const auto settings = parseAttemptSettings(*AttemptRecording::open(file)->settingsAt(200'000));
    EXPECT_EQ(settings->physiology.tilt_deg, 5);
    return settings->blood(0).vein_kPa;
  };
  EXPECT_GT(vein_kPa("internal_jugular"), AttemptSettings().blood(0).vein_kPa + 0.1);
  patient.manifest.targets.front().name = "right common femoral vein";
  EXPECT_LT(vein_kPa("femoral"), AttemptSettings().blood(0).vein_kPa - 0.1);
}

TEST_F(ScriptedSession, UsedNeedleAndANewOne) {
  const std::string pass = R"(, {"advance_mm": 17}, {"withdraw_mm": 17})";
  EXPECT_EQ(run(straight() + pass + pass).metrics[Metric::UsedNeedleInsertions], 1);
  const auto fresh = run(straight() + pass + R"(, {"replace_needle": true})" + pass);
  EXPECT_EQ(fresh.metrics[Metric::UsedNeedleInsertions], 0);
  EXPECT_EQ(fresh.metrics[Metric::Passes], 2);
  EXPECT_EQ(fresh.metrics[Metric::VeinPunctures], 2);
}

TEST_F(ScriptedSession, BoneAndAMiss) {
  const auto outcome = run(straight(12) + R"(, {"advance_mm": 34})", R"("abandoned": true, )");
  EXPECT_THAT(told(outcome), testing::ElementsAre("entered skin", "struck bone"));
  EXPECT_EQ(outcome.metrics[Metric::BoneContacts], 1);
  EXPECT_EQ(outcome.metrics[Metric::TimeToVein], std::nullopt);
  EXPECT_EQ(outcome.status, AttemptStatus::Abandoned);
  EXPECT_EQ(AttemptRecording::open(file)->status(), AttemptStatus::Abandoned);
}

/// The probe over the vein shows the plane z = 0; 5 mm aside it does not.
TEST_F(ScriptedSession, TheTipIsSeenInThePlaneOfThePicture) {
  EXPECT_GT(*run(straight() + R"(, {"advance_mm": 17})").metrics[Metric::TipInImage], 90);
  const std::string aside = R"({"needle": {"from_mm": [0, -5, 5], "to": [0, 12, 5]}}, {"advance_mm": 17})";
  EXPECT_EQ(run(R"({"probe": "auto"}, )" + aside).metrics[Metric::TipInImage], 0);
  EXPECT_EQ(run(R"({"probe": null}, )" + aside).metrics[Metric::TipInImage], 0);
}

TEST_F(ScriptedSession, ReplayAndRepetitionGiveTheSame) {
  const std::string actions =
      straight() + R"(, {"tilt_deg": 15}, {"advance_mm": 27, "speed_mmps": 23}, {"freeze": true},
    {"wait_s": 0.2}, {"freeze": false}, {"withdraw_mm": 12}, {"advance_mm": 6})";
  const auto first = run(actions);
  const auto recording = AttemptRecording::open(file);
  ASSERT_TRUE(recording) << recording.error().message;
  EXPECT_EQ(*recording->metricsUntil(), first.metrics);
  EXPECT_EQ(first.run.metrics().values(), first.metrics);
  EXPECT_EQ(recording->header().caseHash.size(), 16u);
  EXPECT_EQ(recording->header().settingsHash.size(), 16u);
  EXPECT_EQ(parseAttemptSettings(recording->header().settings)->physiology.tilt_deg, 0);
  EXPECT_EQ(parseAttemptSettings(*recording->settingsAt(1'000))->physiology.tilt_deg, 0);
  EXPECT_EQ(parseAttemptSettings(*recording->settingsAt(2'000))->physiology.tilt_deg, 15) << "after the first tick";
  const auto second = run(actions);
  EXPECT_EQ(second.metrics, first.metrics);
  EXPECT_EQ(second.events, first.events);
  const auto again = AttemptRecording::open(file);
  // The ends of stretches depend on the clock, too: an open stretch is on the disk within a second.
  const auto samplesOf = [](const AttemptRecording& from) {
    std::vector<QuantizedSample> samples;
    for (std::size_t i = 0; i < from.segmentCount(); ++i) {
      const auto part = from.segment(i);
      samples.insert(samples.end(), part->samples.begin(), part->samples.end());
    }
    return samples;
  };
  EXPECT_EQ(samplesOf(*again), samplesOf(*recording));
}

TEST_F(ScriptedSession, BadScriptsAreToldWhereAndWhatElse) {
  struct Case {
    const char *text, *sentence;
  };
  for (const Case& c : std::initializer_list<Case>{
           {"{", "The script is not valid JSON"},
           {"[]", "The script must be an object { ... }, not []."},
           {R"({"acts": [], "speed": 2})", "The script has an unknown 'speed'"},
           {R"({"acts": [], "probe": 2})", "The script needs a text as 'probe', not 2."},
           {R"({"acts": [], "abandoned": 2})", "The script needs true or false as 'abandoned', not 2."},
           {R"({"acts": [{"wait_s": 1}, {"advnce_mm": 3}]})",
            "act 2 has an unknown 'advnce_mm'; did you mean 'advance_mm'?"},
           {R"({"acts": [{"advance_mm": -3}]})", "act 1 needs a number from 0 to 200 as 'advance_mm', not -3."},
           {R"({"acts": [{"advance_mm": 3, "wait_s": 1}]})", "act 1 must be an object with one of"},
           {R"({"acts": [{"probe": "nowhere"}]})", "act 1 has a probe that cannot be put there: "},
           {R"({"acts": [{"move_probe_mm": [1, 2]}]})",
            "act 1 needs a list of 3 numbers, [x, y, z] in the probe's frame, as 'move_probe_mm'"},
           {R"({"acts": [{"move_probe_mm": [1, 2, 3]}]})",
            "act 1 moves a probe, but no probe is on the patient. Put the probe first."},
           {R"({"acts": [{"needle": {"from_mm": {"in_probe_mm": [0, 0, 1]}, "to": "vein"}}]})",
            "act 1, needle, has 'from_mm' in the probe's frame, but no probe is on the patient. Put the probe first."},
           {R"({"acts": [{"needle": [1, 2, 3]}]})", "act 1, needle, must be an object { ... }, not [ ... ]."},
           {R"({"acts": [{"needle": {"from_mm": [0, 0, 0], "to": "artery"}}]})", "targets ('vein') as 'to'."},
           {R"({"acts": [{"needle": {"from_mm": [0, 12, 0], "to": "vein"}}]})", "less than 1 mm apart"},
           {R"({"acts": [{"freeze": true}, {"withdraw_mm": 3}]})", "act 2 moves a needle that is frozen. Release it"},
           {R"({"acts": [{"replace_needle": false}]})", "act 1 needs true as 'replace_needle'"}}) {
    const auto script = readSessionScript(c.text, patient);
    ASSERT_FALSE(script) << c.text;
    EXPECT_THAT(script.error().message, HasSubstr(c.sentence));
  }
}

TEST_F(ScriptedSession, CancelledItLeavesNoFile) {
  const auto script = readSessionScript("{\"acts\": [" + straight() + R"(, {"wait_s": 1}]})", patient);
  const auto stopped = runSession(*script, patient, "insonate test", folder / "stopped",
                                  [](std::string_view, double fraction) { return fraction < 0.5; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().message, kCancelled);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace insonate
