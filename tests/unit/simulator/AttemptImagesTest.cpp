#include "support/SmallCase.h"
#include "support/TestData.h"
#include "unit/simulator/LiveProbe.h"

#include <insonate/cases/CaseVersions.h>
#include <insonate/procedure/AttemptRecorder.h>
#include <insonate/simulator/AttemptImages.h>
#include <insonate/simulator/AttemptOrigin.h>
#include <insonate/simulator/AttemptSettings.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/simulator/ScriptedSession.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

namespace insonate {
namespace {

using testing::HasSubstr;
using Frame = std::shared_ptr<const LiveFrame>;

/// A probe on the small block and 4 mm in it, a needle that tents and punctures, a patient that is tilted.
constexpr const char* kActs = R"(
  {"probe": {"position_mm": [0, 0, 0], "axial": [0, 1, 0], "lateral": [1, 0, 0]}},
  {"needle": {"from_mm": [-8, -3, 0], "to": "vein"}}, {"wait_s": 0.3},
  {"probe": {"position_mm": [0, 3.5, 0], "axial": [0, 1, 0], "lateral": [1, 0, 0]}}, {"wait_s": 0.2},
  {"advance_mm": 14, "speed_mmps": 20}, {"tilt_deg": 15}, {"wait_s": 0.2},
  {"probe": null}, {"wait_s": 0.3})";

class AttemptPicturesTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto script = readSessionScript("{\"acts\": [" + std::string(kActs) + "]}", *patient);
    ASSERT_TRUE(script) << script.error().message;
    SessionImages pictures{.every_us = 100'000, .take = [&](const LiveFrame& frame) -> Result<void> {
                             shown[std::llround(frame.time_s * 1e6)] = std::make_shared<LiveFrame>(frame);
                             return {};
                           }};
    const auto outcome = runSession(*script, *patient, "insonate test", folder / "attempt", {}, pictures);
    ASSERT_TRUE(outcome) << outcome.error().message;
    metrics = outcome->metrics;
  }
  AttemptImages open(const std::string& name = "attempt", bool workAhead = false) const {
    return open(name, patient, workAhead);
  }
  AttemptImages open(const std::string& name, const std::shared_ptr<const PatientCase>& of,
                     bool workAhead = false) const {
    auto recording = AttemptRecording::open(folder / name);
    auto made = AttemptImages::make(std::make_shared<const AttemptRecording>(std::move(*recording)), of, workAhead);
    EXPECT_TRUE(made) << made.error().message;
    return std::move(*made);
  }
  AttemptSample recordedAt(std::int64_t time_us) const {
    AttemptSample last;
    EXPECT_TRUE(AttemptRecording::open(folder / "attempt")->play(time_us, [&](const RecordingSegment::Entry& entry) {
      if (const auto* sample = std::get_if<AttemptSample>(&entry)) last = *sample;
    }));
    return last;
  }
  static void expectSame(const LiveFrame& a, const LiveFrame& b) {
    EXPECT_EQ(a.image.gray, b.image.gray);
    EXPECT_EQ(a.envelope.amplitude, b.envelope.amplitude);
    EXPECT_EQ(a.press.force_N, b.press.force_N);
    EXPECT_EQ(a.needle, b.needle);
  }

  const std::shared_ptr<const PatientCase> patient = std::make_shared<const PatientCase>(test::smallAttemptCase());
  const test::TemporaryFolder folder;
  std::map<std::int64_t, Frame> shown;  ///< by the session, by time in us
  MetricValues metrics;
};

/// Forwards, backwards, and by another that has seen nothing before.
TEST_F(AttemptPicturesTest, AreThoseOfTheSessionBitForBit) {
  ASSERT_EQ(shown.size(), 14u) << "1.4 s of a probe that is held";
  AttemptImages pictures = open();
  for (const auto& [time_us, frame] : shown) {
    const auto again = pictures.at(time_us);
    ASSERT_TRUE(again) << again.error().message;
    expectSame(**again, *frame);
  }
  for (auto it = shown.rbegin(); it != shown.rend(); ++it) expectSame(**pictures.at(it->first), *it->second);
  expectSame(**open("attempt", true).at(1'200'000), *shown[1'200'000]);
}

TEST_F(AttemptPicturesTest, AFaceInTheSkinPressesAndTheForceIsTheRecordings) {
  const LiveDeformation &light = shown[200'000]->press, &hard = shown[500'000]->press;
  EXPECT_NEAR(light.indentation_mm, 0.5, 0.1);
  EXPECT_NEAR(hard.indentation_mm, 4, 0.1);
  EXPECT_GT(hard.force_N, 2 * light.force_N);
  const auto vein = std::ranges::find(hard.lumens, kVein, &LumenArea::label);
  ASSERT_NE(vein, hard.lumens.end());
  EXPECT_LT(vein->area_mm2, 0.95 * vein->rest_mm2) << "the vein gives way";
  const AttemptSample sample = recordedAt(500'000);
  ASSERT_EQ(sample.time_us, 500'000);
  EXPECT_NEAR(sample.probeForce_N, hard.force_N, kForceQuantum_N);
  EXPECT_NEAR(*metrics[Metric::ProbeForceMost], hard.force_N, 0.3 * hard.force_N) << "tilted, the vein is fuller";
}

TEST_F(AttemptPicturesTest, ShowNeedleTiltAndNothingWithoutAProbe) {
  EXPECT_NE(shown[900'000]->image.gray, shown[1'200'000]->image.gray) << "the needle goes on";
  EXPECT_TRUE(shown[800'000]->needle);
  EXPECT_GT(shown[1'400'000]->press.pressure.vein_kPa, shown[1'200'000]->press.pressure.vein_kPa) << "head down";
  AttemptImages pictures = open();
  EXPECT_EQ(*pictures.at(0), nullptr) << "before the first sample";
  EXPECT_EQ(*pictures.at(1'600'000), nullptr) << "nobody holds the probe";
  EXPECT_NE(*pictures.at(1'400'900), nullptr) << "between two samples: the one before";
}

/// Frozen, then moved away and the patient tilted: the image is that of the moment before.
TEST_F(AttemptPicturesTest, AFrozenPictureStandsInTheSessionAndInItsReplay) {
  const auto script = readSessionScript(R"({"acts": [
    {"probe": {"position_mm": [0, 0, 0], "axial": [0, 1, 0], "lateral": [1, 0, 0]}}, {"wait_s": 0.25}, {"freeze": true},
    {"tilt_deg": 20}, {"move_probe_mm": [3, 0, 0]}, {"freeze": false}, {"wait_s": 0.2}]})",
                                        *patient);
  ASSERT_TRUE(script) << script.error().message;
  std::map<std::int64_t, Frame> taken;
  const SessionImages wanted{.every_us = 100'000, .take = [&](const LiveFrame& frame) -> Result<void> {
                               taken[std::llround(frame.time_s * 1e6)] = std::make_shared<LiveFrame>(frame);
                               return {};
                             }};
  ASSERT_TRUE(runSession(*script, *patient, "insonate test", folder / "frozen", {}, wanted));
  std::vector<std::int64_t> times_us;
  for (const auto& [time_us, frame] : taken) times_us.push_back(time_us);
  EXPECT_THAT(times_us, testing::ElementsAre(100'000, 200'000, 250'000, 600'000, 700'000)) << "moved for 0.3 s";
  AttemptImages pictures = open("frozen");
  for (const std::int64_t frozen_us : {300'000, 400'000, 500'000}) {
    const auto frame = pictures.at(frozen_us);
    ASSERT_TRUE(frame && *frame);
    EXPECT_EQ(std::llround((*frame)->time_s * 1e6), 250'000);
    expectSame(**frame, *taken[250'000]);
  }
  expectSame(**pictures.at(600'000), *taken[600'000]);
}

/// The command line's image of the same moment, for a probe that does not press.
TEST_F(AttemptPicturesTest, ArePicturesOfTheCase) {
  AttemptSettings settings;
  settings.setup = {*loadProbe("linear"), settingsFor(*loadProbe("linear")), *loadAcousticTable("neck"), "cpu"};
  const Transform pose = *patientFromProbe({1, -0.6, 0}, {0, 1, 0}, {1, 0, 0});
  AttemptHeader header{.caseHash = voxelHashOf(*patient), .settings = textOf(settings)};
  auto recorder = AttemptRecorder::start(folder / "still", header);
  (*recorder)->record(AttemptSample{.time_us = 1000, .patientFromProbe = pose, .imageDepth_mm = 40});
  ASSERT_TRUE((*recorder)->finish(AttemptStatus::Completed));
  auto imager = Imager::make(settings.setup);
  const auto scene = makeScene(*patient, settings.setup, sceneRegion(settings.setup, pose));
  ImagingFrame expected;
  expected.noiseSeed = 1000;  // µs
  imager->render(**scene, pose, expected);
  const auto frame = open("still").at(1000);
  ASSERT_TRUE(frame) << frame.error().message;
  ASSERT_EQ((*frame)->image.gray.size(), expected.image.gray.size());
  int most = 0;
  for (std::size_t i = 0; i < expected.image.gray.size(); ++i)
    most = std::max(most, std::abs(int{(*frame)->image.gray[i]} - int{expected.image.gray[i]}));
  EXPECT_LE(most, 4)
      << "of 255: scenes of another extent round otherwise, and strands 30 dB over their surroundings show it";
}

/// A live image that has come to rest, after the tissue was pressed and let go on its way there.
TEST_F(AttemptPicturesTest, LiveOnesAreNear) {
  AttemptSettings settings;
  settings.setup = test::smallSetup();
  settings.setup.mechanics.model = "elastic";
  settings.setup.mechanics.settings.mesh_mm = 1;
  LiveOptions options;
  options.keepEnvelopes = true, options.workAhead = false;
  const auto pressed = [](double in_mm) { return *patientFromProbe({0, in_mm, 0}, {0, 1, 0}, {1, 0, 0}); };
  const auto wide = test::wideCase();
  test::Live live(pressed(0), settings.setup, options, wide);
  for (const double in_mm : {1.0, 3.0, 5.0, 4.0, 3.0}) live.frameAt(pressed(in_mm));
  ASSERT_TRUE(live.until([&] { return live->latest()->press.settled; }, std::chrono::seconds(30)));
  const Frame seen = live->latest();
  ASSERT_GT(seen->press.force_N, 0.1);

  auto recorder =
      AttemptRecorder::start(folder / "live", {.caseHash = voxelHashOf(*wide), .settings = textOf(settings)});
  (*recorder)->record(AttemptSample{.time_us = 1000, .patientFromProbe = seen->patientFromProbe, .imageDepth_mm = 25});
  ASSERT_TRUE((*recorder)->finish(AttemptStatus::Completed));
  const Frame again = *open("live", wide).at(1000);
  EXPECT_NEAR(again->press.force_N, seen->press.force_N, 0.02 * seen->press.force_N);
  double difference = 0, sum = 0;
  for (std::size_t i = 0; i < seen->envelope.amplitude.size(); ++i) {
    difference += std::pow(again->envelope.amplitude[i] - seen->envelope.amplitude[i], 2);
    sum += std::pow(seen->envelope.amplitude[i], 2);
  }
  RecordProperty("envelope_difference_percent", std::to_string(100 * std::sqrt(difference / sum)));
  // Tissue that is solved from rest lies some micrometers elsewhere. Strands of connective tissue are thin and bright:
  // a gate beside one then lies on it or not.
  EXPECT_LT(std::sqrt(difference / sum), 0.1);
}

/// While the image stands still, the hands go on.
TEST_F(AttemptPicturesTest, AFrozenPictureStays) {
  const auto recording = AttemptRecording::open(folder / "attempt");
  AttemptHeader header = recording->header();
  auto recorder = AttemptRecorder::start(folder / "frozen", header);
  AttemptSample sample = recordedAt(500'000);
  (*recorder)->record(sample);
  sample.patientFromProbe->offset.x += 5, sample.imageDepth_mm = 0;
  for (sample.time_us = 600'000; sample.time_us < 3'000'000; sample.time_us += 100'000) (*recorder)->record(sample);
  sample.imageDepth_mm = 40;
  (*recorder)->record(sample);
  ASSERT_TRUE((*recorder)->finish(AttemptStatus::Completed));
  AttemptImages pictures = open("frozen");
  const Frame before = *pictures.at(500'000);
  expectSame(**pictures.at(2'900'000), *before);
  EXPECT_EQ((*pictures.at(3'000'000))->patientFromProbe.offset.x, before->patientFromProbe.offset.x + 5);
}

TEST_F(AttemptPicturesTest, AreRefusedWithASentence) {
  const auto recording = std::make_shared<const AttemptRecording>(*AttemptRecording::open(folder / "attempt"));
  auto other = std::make_shared<PatientCase>(test::smallAttemptCase());
  other->labels.at(0, 10, 0) = kFat;
  EXPECT_THAT(AttemptImages::make(recording, other).error().message,
              HasSubstr("was made on another case, 'Small block'"));
  auto recorder = AttemptRecorder::start(folder / "unset", {.caseHash = voxelHashOf(*patient)});
  ASSERT_TRUE((*recorder)->finish(AttemptStatus::Completed));
  const auto unset = std::make_shared<const AttemptRecording>(*AttemptRecording::open(folder / "unset"));
  EXPECT_THAT(AttemptImages::make(unset, patient).error().message, HasSubstr("has no image settings"));
}

}  // namespace
}  // namespace insonate
