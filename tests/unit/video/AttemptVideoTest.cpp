#include "WebmReader.h"
#include "attempt/ReplayCursor.h"
#include "support/SmallCase.h"
#include "support/TestData.h"

#include <insonate/cases/CaseVersions.h>
#include <insonate/procedure/AttemptRecorder.h>
#include <insonate/simulator/AttemptCase.h>
#include <insonate/simulator/AttemptImages.h>
#include <insonate/simulator/ScriptedSession.h>
#include <insonate/ultrasound/BeamGrid.h>
#include <insonate/video/AttemptVideo.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace insonate {
namespace {

using test::WebmReader;
using testing::HasSubstr;

/// A needle into the vein, which aspirates blood, is withdrawn and replaced; then the probe is lifted.
constexpr const char* kActs = R"(
  {"probe": {"position_mm": [0, 0.5, 0], "axial": [0, 1, 0], "lateral": [1, 0, 0]}},
  {"needle": {"from_mm": [-8, -3, 0], "to": "vein"}}, {"wait_s": 0.2},
  {"advance_mm": 19, "speed_mmps": 40}, {"aspirate": true}, {"wait_s": 0.3}, {"aspirate": false},
  {"freeze": true}, {"wait_s": 0.4}, {"freeze": false},
  {"withdraw_mm": 25, "speed_mmps": 60}, {"replace_needle": true}, {"wait_s": 0.1},
  {"probe": null}, {"wait_s": 0.4})";

class AttemptVideoTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const auto script = readSessionScript("{\"acts\": [" + std::string(kActs) + "]}", *patient);
    ASSERT_TRUE(script) << script.error().message;
    const auto outcome = runSession(*script, *patient, "insonate test", folder / "attempt");
    ASSERT_TRUE(outcome) << outcome.error().message;
  }
  static std::shared_ptr<const AttemptRecording> recording() {
    return std::make_shared<const AttemptRecording>(std::move(*AttemptRecording::open(folder / "attempt")));
  }
  static std::int64_t timeOf(AttemptEventKind kind) {
    std::int64_t time_us = -1;
    EXPECT_TRUE(recording()->play(recording()->end_us(), [&](const RecordingSegment::Entry& entry) {
      const auto* event = std::get_if<AttemptEvent>(&entry);
      if (event && event->kind == kind) time_us = event->time_us;
    }));
    EXPECT_GE(time_us, 0);
    return time_us;
  }

  static inline const std::shared_ptr<const PatientCase> patient =
      std::make_shared<const PatientCase>(test::smallAttemptCase());
  static inline const test::TemporaryFolder folder{};
};

/// Correlation of a frame with the image of its time, where the layout has it: 650 x 418 pixels at (56, 30), centered.
double correlation(const WebmReader::Frame& frame, const BModeImage& image) {
  const double scale = std::min(650.0 / image.width, 418.0 / image.height);
  const double left = 56 + (650 - image.width * scale) / 2;
  double n = 0, a = 0, b = 0, aa = 0, bb = 0, ab = 0;
  for (int y = 2; y < image.height - 2; ++y)
    for (int x = 2; x < image.width - 2; ++x) {
      const auto column = std::size_t(left + (x + 0.5) * scale), row = std::size_t(30 + (y + 0.5) * scale);
      const double shown = frame.luma[row * kAttemptVideoWidth_px + column];
      const double gray = image.gray[std::size_t(y) * image.width + x];
      n += 1, a += shown, b += gray, aa += shown * shown, bb += gray * gray, ab += shown * gray;
    }
  return (ab / n - a / n * b / n) / std::sqrt((aa / n - a * a / n / n) * (bb / n - b * b / n / n));
}

TEST_F(AttemptVideoTest, ShowsTheImageOfEachTime) {
  const auto file = folder / "attempt.webm";
  const auto written = writeAttemptVideo(recording(), patient, file, {.framesPerSecond = 10});
  ASSERT_TRUE(written) << written.error().message;
  const WebmReader read(file);
  EXPECT_EQ(read.width, kAttemptVideoWidth_px);
  EXPECT_EQ(read.height, kAttemptVideoHeight_px);
  ASSERT_EQ(std::int64_t(read.frames.size()), recording()->end_us() / 100'000 + 1);
  auto pictures = AttemptImages::make(recording(), patient);
  ASSERT_TRUE(pictures);
  const auto frameAt = [&](std::int64_t time_us) { return read.frames[std::size_t(time_us / 100'000)]; };
  const std::int64_t frozen_us = timeOf(AttemptEventKind::Frozen);
  for (const std::int64_t time_us : {std::int64_t{100'000}, std::int64_t{500'000}, frozen_us + 200'000}) {
    const std::int64_t shown_us = time_us / 100'000 * 100'000;
    const auto image = pictures->at(shown_us);
    ASSERT_TRUE(image && *image) << shown_us;
    EXPECT_GT(correlation(frameAt(shown_us), (*image)->image), 0.93) << shown_us;
  }
  const double own = correlation(frameAt(100'000), (*pictures->at(100'000))->image);
  EXPECT_LT(correlation(frameAt(100'000), (*pictures->at(600'000))->image), own) << "another time has another needle";
  const auto& lifted = frameAt(recording()->end_us());
  const auto bright = std::ranges::count_if(lifted.luma.begin(), lifted.luma.begin() + 200 * kAttemptVideoWidth_px,
                                            [](std::uint8_t luma) { return luma > 60; });
  EXPECT_EQ(bright, 0) << "no image without a probe";
}

TEST_F(AttemptVideoTest, TheDepthScaleIsAtTheEdgeOfTheFieldOfView) {
  const auto file = folder / "scale.webm";
  ASSERT_TRUE(writeAttemptVideo(recording(), patient, file, {.framesPerSecond = 2}));
  auto pictures = AttemptImages::make(recording(), patient);
  ASSERT_TRUE(pictures);
  const auto frame = pictures->at(500'000);
  ASSERT_TRUE(frame && *frame);
  const BModeImage& image = (*frame)->image;
  const double scale = std::min(650.0 / image.width, 418.0 / image.height);
  const double imageLeft = 56 + (650 - image.width * scale) / 2;
  const BeamGrid grid((*frame)->setup->probe, (*frame)->setup->settings);
  const double left = imageLeft + ((grid.minLateral_mm() - image.left_mm) / image.pixel_mm + 0.5) * scale;
  ASSERT_GT(left, imageLeft + 20) << "black beside the field of view";
  const WebmReader read(file);
  // Marks end 8 pixels left of the field of view; each is 4 or 8 pixels long.
  const auto marksIn = [&](double from, double to) {
    int marks = 0;
    for (std::size_t y = 30; y < 448; ++y)
      for (auto x = std::size_t(from); x < std::size_t(to); ++x)
        marks += read.frames.at(1).luma[y * kAttemptVideoWidth_px + x] > 60;
    return marks;
  };
  EXPECT_GT(marksIn(left - 12, left - 8), 4 * int((image.height - 1) * image.pixel_mm / 5));
  EXPECT_EQ(marksIn(imageLeft - 16, imageLeft - 4), 0);
}

TEST_F(AttemptVideoTest, TheStripShowsNeedleAndSyringe) {
  auto procedure = loadProcedure("internal_jugular");
  ASSERT_TRUE(procedure);
  video::ReplayCursor replay(recording(), *procedure);
  ASSERT_TRUE(replay.advance(100'000));
  EXPECT_EQ(replay.run().metrics().needle(), NeedlePlace::Clean);
  EXPECT_EQ(replay.syringe(), SyringeContent::Nothing);
  ASSERT_TRUE(replay.advance(timeOf(AttemptEventKind::Frozen)));
  EXPECT_EQ(replay.run().metrics().needle(), NeedlePlace::Vein);
  EXPECT_EQ(replay.syringe(), SyringeContent::DarkBlood);
  EXPECT_EQ(displayText(replay.syringe(), false), "dark red blood, non-pulsatile");
  ASSERT_TRUE(replay.advance(timeOf(AttemptEventKind::NeedleReplaced) - 1));
  EXPECT_EQ(replay.run().metrics().needle(), NeedlePlace::Used);
  EXPECT_EQ(replay.syringe(), SyringeContent::DarkBlood) << "it stays in the syringe";
  ASSERT_TRUE(replay.advance(recording()->end_us()));
  EXPECT_EQ(replay.syringe(), SyringeContent::Nothing);
  EXPECT_EQ(replay.run().metrics().values(), *recording()->metricsUntil()) << "nothing was left out";
}

TEST_F(AttemptVideoTest, MomentsAreThoseOfTheScore) {
  const auto moments = momentsOf(*recording());
  ASSERT_TRUE(moments);
  ASSERT_FALSE(moments->empty());
  const auto frozen = std::ranges::find(*moments, timeOf(AttemptEventKind::Frozen), &AttemptMoment::time_us);
  EXPECT_NE(frozen, moments->end());
  EXPECT_TRUE(std::ranges::is_sorted(*moments, {}, &AttemptMoment::time_us));
}

TEST_F(AttemptVideoTest, AProcedureThatIsAFileIsNotRead) {
  AttemptHeader header = recording()->header();
  header.procedure = "/etc/passwd";
  const auto recorder = AttemptRecorder::start(folder / "foreign", header);
  ASSERT_TRUE(recorder && (*recorder)->finish(AttemptStatus::Completed));
  const auto moments = momentsOf(*AttemptRecording::open(folder / "foreign"));
  ASSERT_FALSE(moments);
  EXPECT_THAT(moments.error().message, HasSubstr("'/etc/passwd' is not a built-in procedure"));
}

TEST_F(AttemptVideoTest, ItsCaseIsFoundByItsVoxels) {
  const auto cases = folder / "cases";
  std::filesystem::create_directories(cases / "empty");
  ASSERT_TRUE(writeCase(*patient, cases / "block"));
  const AttemptHeader header = recording()->header();
  const auto found = caseOfAttempt(header, {cases});
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_EQ(voxelHashOf(*found), header.caseHash);
  const auto none = caseOfAttempt(header, {});
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, HasSubstr("Small block"));
  EXPECT_THAT(none.error().message, HasSubstr("no folder of cases is named"));
  PatientCase changed = *patient;
  changed.ct.at(20, 20, 8) += 100;
  ASSERT_TRUE(saveCaseVersion(changed, cases / "block", "2026-11-22", ""));
  EXPECT_TRUE(caseOfAttempt(header, {cases})) << "an earlier version is kept";
  const auto other = caseOfAttempt(header, {cases / "empty"});
  ASSERT_FALSE(other);
  EXPECT_THAT(other.error().message, HasSubstr("Copy the case there"));
}

TEST_F(AttemptVideoTest, RefusesWhatItCannotShow) {
  PatientCase changed = *patient;
  changed.ct.at(20, 20, 8) += 100;
  const auto file = folder / "none.webm";
  const auto other = writeAttemptVideo(recording(), std::make_shared<const PatientCase>(changed), file);
  ASSERT_FALSE(other);
  EXPECT_THAT(other.error().message, HasSubstr("another case"));
  const auto cancelled =
      writeAttemptVideo(recording(), patient, file, {}, [](std::string_view, double) { return false; });
  ASSERT_FALSE(cancelled);
  EXPECT_EQ(cancelled.error().message, kCancelled);
  EXPECT_FALSE(std::filesystem::exists(file));
}

}  // namespace
}  // namespace insonate
