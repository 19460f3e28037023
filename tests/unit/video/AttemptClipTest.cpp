#include "support/SmallCase.h"
#include "support/TestData.h"

#include <insonate/cases/CaseVersions.h>
#include <insonate/procedure/AttemptRecorder.h>
#include <insonate/simulator/AttemptImages.h>
#include <insonate/simulator/AttemptSettings.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/simulator/ScriptedSession.h>
#include <insonate/video/AttemptClip.h>

#include <gdcmAttribute.h>
#include <gdcmImageReader.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

namespace insonate {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class AttemptClipTest : public testing::Test {
 protected:
  std::shared_ptr<const AttemptRecording> recorded(const std::string& actions) const {
    const auto script = readSessionScript("{\"acts\": [" + actions + "]}", *patient);
    EXPECT_TRUE(script) << script.error().message;
    const auto outcome = runSession(*script, *patient, "insonate test", folder / "attempt");
    EXPECT_TRUE(outcome) << outcome.error().message;
    return std::make_shared<const AttemptRecording>(std::move(*AttemptRecording::open(folder / "attempt")));
  }

  const std::shared_ptr<const PatientCase> patient = std::make_shared<const PatientCase>(test::smallAttemptCase());
  const test::TemporaryFolder folder{};
  const std::filesystem::path file = folder / "attempt.dcm";
};

constexpr const char* kHeld = R"({"probe": {"position_mm": [0, 0.5, 0], "axial": [0, 1, 0], "lateral": [1, 0, 0]}},
  {"wait_s": 0.3}, {"needle": {"from_mm": [-8, -3, 0], "to": "vein"}}, {"advance_mm": 19, "speed_mmps": 40})";

TEST_F(AttemptClipTest, HasTheImageOfEachTimeWithItsScale) {
  const auto recording = recorded(std::string("{\"wait_s\": 0.3}, ") + kHeld + R"(, {"probe": null}, {"wait_s": 0.4})");
  const auto written = writeAttemptClip(recording, patient, file, {.framesPerSecond = 10});
  ASSERT_TRUE(written) << written.error().message;
  gdcm::ImageReader reader;
  reader.SetFileName(file.c_str());
  ASSERT_TRUE(reader.Read());
  const gdcm::Image& read = reader.GetImage();
  std::vector<char> bytes(read.GetBufferLength());
  ASSERT_TRUE(read.GetBuffer(bytes.data()));
  const std::size_t frames = std::size_t(recording->end_us() / 100'000 + 1);
  ASSERT_EQ(read.GetDimension(2), frames);
  auto pictures = AttemptImages::make(recording, patient);
  ASSERT_TRUE(pictures);
  const auto frameAt = [&](std::size_t index) {
    const std::size_t size = bytes.size() / frames;
    return std::vector<std::uint8_t>(bytes.begin() + std::ptrdiff_t(index * size),
                                     bytes.begin() + std::ptrdiff_t((index + 1) * size));
  };
  std::size_t held = 0;
  for (std::size_t i = 0; i < frames; ++i) {
    const auto image = pictures->at(std::int64_t(i) * 100'000);
    ASSERT_TRUE(image);
    if (!*image) {
      EXPECT_EQ(std::ranges::count(frameAt(i), 0), std::ptrdiff_t(bytes.size() / frames)) << i;
      continue;
    }
    ++held;
    EXPECT_EQ(frameAt(i), (*image)->image.gray) << i;
    EXPECT_NEAR(10 * read.GetSpacing(0), (*image)->image.pixel_mm, 1e-9) << "GDCM leaves the unit, which is cm";
  }
  EXPECT_GT(held, 3U);
  EXPECT_LT(held, frames);
  gdcm::Attribute<0x0018, 0x1063> interval;
  interval.Set(reader.GetFile().GetDataSet());
  EXPECT_NEAR(interval.GetValue(), 100, 1e-9);
}

TEST_F(AttemptClipTest, EqualRecordingsHaveEqualNames) {
  const auto recording = recorded(kHeld);
  const auto instanceOf = [&](int framesPerSecond) {
    EXPECT_TRUE(writeAttemptClip(recording, patient, file, {.framesPerSecond = framesPerSecond}));
    gdcm::Reader reader;
    reader.SetFileName(file.c_str());
    EXPECT_TRUE(reader.Read());
    gdcm::Attribute<0x0008, 0x0018> instance;
    instance.Set(reader.GetFile().GetDataSet());
    return std::string(instance.GetValue());
  };
  const std::string first = instanceOf(2);
  EXPECT_EQ(instanceOf(2), first);
  EXPECT_NE(instanceOf(3), first) << "other frames";
}

TEST_F(AttemptClipTest, AnotherDepthIsRefused) {
  AttemptSettings settings;
  settings.setup = {*loadProbe("linear"), settingsFor(*loadProbe("linear")), *loadAcousticTable("neck"), "cpu"};
  AttemptSettings deeper = settings;
  deeper.setup.settings.depth_mm += 10;
  const auto recorder = AttemptRecorder::start(
      folder / "deeper",
      {.procedure = "internal_jugular", .caseHash = voxelHashOf(*patient), .settings = textOf(settings)});
  ASSERT_TRUE(recorder);
  const Transform pose = *patientFromProbe({0, -0.5, 0}, {0, 1, 0}, {1, 0, 0});
  (*recorder)->recordFromOtherThread(SettingsChange{600'000, textOf(deeper)});
  for (const std::int64_t time_us : {1000, 500'000, 700'000, 900'000})
    (*recorder)->record(AttemptSample{.time_us = time_us, .patientFromProbe = pose, .imageDepth_mm = 40});
  ASSERT_TRUE((*recorder)->finish(AttemptStatus::Completed));
  const auto recording =
      std::make_shared<const AttemptRecording>(std::move(*AttemptRecording::open(folder / "deeper")));
  const auto written = writeAttemptClip(recording, patient, file, {.framesPerSecond = 10});
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().message,
              AllOf(HasSubstr("After 0.7 s"), HasSubstr("one scale"), HasSubstr("Write a video (.webm) instead")));
  EXPECT_FALSE(std::filesystem::exists(file));
}

/// With so much gain, the noise alone gives color.
TEST_F(AttemptClipTest, AnAttemptWithColorHasAColoredClip) {
  AttemptSettings settings;
  settings.setup = {*loadProbe("linear"), settingsFor(*loadProbe("linear")), *loadAcousticTable("neck"), "cpu"};
  AttemptSettings colored = settings;
  colored.setup.color = colorSettingsFor(settings.setup.probe, settings.setup.settings);
  colored.setup.color->gain_dB = 30, colored.setup.color->priority = 1;
  const auto recorder = AttemptRecorder::start(
      folder / "colored",
      {.procedure = "internal_jugular", .caseHash = voxelHashOf(*patient), .settings = textOf(settings)});
  ASSERT_TRUE(recorder);
  const Transform pose = *patientFromProbe({0, -0.5, 0}, {0, 1, 0}, {1, 0, 0});
  (*recorder)->recordFromOtherThread(SettingsChange{200'000, textOf(colored)});
  for (const std::int64_t time_us : {1000, 150'000, 250'000, 350'000})
    (*recorder)->record(AttemptSample{.time_us = time_us, .patientFromProbe = pose, .imageDepth_mm = 40});
  ASSERT_TRUE((*recorder)->finish(AttemptStatus::Completed));
  const auto recording =
      std::make_shared<const AttemptRecording>(std::move(*AttemptRecording::open(folder / "colored")));
  ASSERT_TRUE(writeAttemptClip(recording, patient, file, {.framesPerSecond = 10}));
  gdcm::ImageReader reader;
  reader.SetFileName(file.c_str());
  ASSERT_TRUE(reader.Read());
  const gdcm::Image& read = reader.GetImage();
  ASSERT_EQ(read.GetPixelFormat().GetSamplesPerPixel(), 3);
  std::vector<char> bytes(read.GetBufferLength());
  ASSERT_TRUE(read.GetBuffer(bytes.data()));
  const std::size_t frames = read.GetDimension(2), size = bytes.size() / frames;
  const auto coloredPixels = [&](std::size_t frame) {
    std::size_t count = 0;
    for (std::size_t i = frame * size; i + 2 < (frame + 1) * size; i += 3)
      count += bytes[i] != bytes[i + 1] || bytes[i] != bytes[i + 2];
    return count;
  };
  EXPECT_EQ(coloredPixels(1), 0U) << "before color was switched on";
  EXPECT_GT(coloredPixels(frames - 1), 1000U);
}

TEST_F(AttemptClipTest, RefusesWhatIsNoClip) {
  const auto never = writeAttemptClip(recorded(R"({"wait_s": 0.5})"), patient, file, {.framesPerSecond = 10});
  ASSERT_FALSE(never);
  EXPECT_THAT(never.error().message, HasSubstr("No probe is held"));
  std::filesystem::remove(folder / "attempt");
  const auto recording = recorded(kHeld);
  const auto cancelled = writeAttemptClip(recording, patient, file, {}, [](std::string_view, double) { return false; });
  ASSERT_FALSE(cancelled);
  EXPECT_EQ(cancelled.error().message, kCancelled);
  EXPECT_FALSE(std::filesystem::exists(file));
}

}  // namespace
}  // namespace insonate
