#include "LiveProbe.h"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <set>

namespace insonate {
namespace {

using testing::HasSubstr;
using namespace std::chrono_literals;
using namespace test;

TEST(LiveImaging, FirstFrameArrivesWithAllThatLedToIt) {
  Live live(poseAt(3));
  Frame frame;
  ASSERT_TRUE(live.until([&] { return (frame = live->latest()) != nullptr; }));
  EXPECT_GE(frame->number, 1u) << "the coarse image, or already the next one";
  EXPECT_EQ(frame->patientFromProbe, poseAt(3));
  EXPECT_EQ(frame->image.width, 128);
  EXPECT_EQ(frame->setup->probe.name, smallSetup().probe.name);
  EXPECT_EQ(frame->setup->settings.depth_mm, 25);
  EXPECT_FALSE(frame->stages.empty());
  EXPECT_GT(frame->frame_ms, 0);
  EXPECT_GT(frame->time_s, 0);
  EXPECT_TRUE(frame->warnings->empty());
  EXPECT_TRUE(frame->envelope.amplitude.empty());
  ASSERT_TRUE(live.until([&] { return live->status().state == LiveState::Imaging; }));
  live.settle();
  EXPECT_GT(live->status().sceneBuild_ms, 0);
  EXPECT_EQ(live->status().scenesBuilt, 2) << "a small one for the first picture, then one with room to move";
}

/// The block with a vein along z, in the long axis.
TEST(LiveImaging, ColorShowsTheFlowInNamedVesselsAndFlashesWhileTheProbeMoves) {
  auto patient = std::make_shared<PatientCase>(*wideCase());
  patient->manifest.vessels = {{"right internal jugular vein", kVein, {{{0, 12, -20}, 5}, {{0, 12, 20}, 5}}}};
  ImagingSetup setup = smallSetup();
  setup.color = colorSettingsFor(setup.probe, setup.settings);
  setup.color->steering_deg = 20, setup.color->persistence = 0;
  setup.color->left = 0, setup.color->right = 1;
  const auto coloredPixels = [](const Frame& frame) {
    int count = 0;
    for (std::size_t i = 0; i < frame->color.rgba.size(); i += 4)
      count += frame->color.rgba[i + 3] != 0 && frame->color.rgba[i] != frame->color.rgba[i + 2];
    return count;
  };
  const auto alongVein = [](double x_mm) { return *patientFromProbe({x_mm, 0, 0}, {0, 1, 0}, {0, 0, 1}); };
  Live live(alongVein(0), setup, {}, patient);
  ASSERT_TRUE(live.frameAt(alongVein(0)));
  live.settle();
  const Frame still = live->latest();
  const int flow = coloredPixels(still), all = still->color.width * still->color.height;
  EXPECT_GT(flow, all / 10);
  EXPECT_LT(flow, 6 * all / 10);
  // A probe that is pushed 10 mm within an image moves far faster than blood.
  Transform pushed = alongVein(0);
  pushed.offset.y = 10;
  EXPECT_GT(coloredPixels(live.frameAt(pushed)), 8 * all / 10);
}

TEST(LiveImaging, LatestPoseWins) {
  Live live;
  ASSERT_TRUE(live.frameAt(poseAt(0)));
  std::vector<std::thread> hands;
  for (int hand = 0; hand < 3; ++hand)
    hands.emplace_back([&] {
      for (int i = 0; i < 300; ++i) live->setPose(poseAt(0.01 * i));
    });
  for (std::thread& hand : hands) hand.join();
  const Frame last = live.frameAt(poseAt(5));
  ASSERT_TRUE(last);
  EXPECT_LT(last->number, 800u) << "poses in between are left out";
  live.settle();
  EXPECT_EQ(live->latest(), last);
}

TEST(LiveImaging, AStillProbeMakesNoPictures) {
  Live live;
  ASSERT_TRUE(live.frameAt(poseAt(0)));
  live.settle();
  const Frame frame = live->latest();
  const int calls = live.calls();
  for (int i = 0; i < 5; ++i) live->setPose(poseAt(0));
  std::this_thread::sleep_for(100ms);
  EXPECT_EQ(live->latest(), frame);
  EXPECT_EQ(live.calls(), calls);
}

TEST(LiveImaging, PersistenceSettlesAndThenRests) {
  ImagingSetup setup = smallSetup();
  setup.settings.persistence = 0.5;
  Live live(poseAt(0), setup);
  ASSERT_TRUE(live.frameAt(poseAt(0)));
  live.settle();
  ASSERT_TRUE(live.frameAt(poseAt(8)));
  const auto picturesThere = [&] {
    return std::ranges::count_if(live->cine(1e9),
                                 [](const Frame& frame) { return frame->patientFromProbe == poseAt(8); });
  };
  ASSERT_TRUE(live.until([&] { return picturesThere() >= 10; }));
  std::this_thread::sleep_for(100ms);
  EXPECT_EQ(picturesThere(), 10) << "0.5^9 of 255 grey levels is the first below a half";
  const Frame settled = live->latest();
  setup.settings.persistence = 0;
  // Half a gray is left of the former image; interpolation between scanlines overshoots.
  EXPECT_LE(greatestDifference(settled->image, freshPicture(*wideCase(), setup, poseAt(8))), 2);
}

TEST(LiveImaging, EachFrameHasElectronicNoiseOfItsOwn) {
  ImagingSetup setup = smallSetup();
  setup.settings.effects.noise = true, setup.settings.noise_dB = -10;
  Live live(poseAt(0), setup);
  const Frame first = live.frameAt(poseAt(0));
  ASSERT_TRUE(first && live.frameAt(poseAt(8)));
  const Frame again = live.frameAt(poseAt(0));
  ASSERT_TRUE(again);
  EXPECT_GT(greatestDifference(first->image, again->image), 20);
  for (const Frame& frame : {first, again})
    EXPECT_LE(greatestDifference(frame->image, freshPicture(*wideCase(), setup, poseAt(0), frame->number)), 1);
}

TEST(LiveImaging, PicturesDoNotDependOnTheSceneTheyAreMadeFrom) {
  LiveOptions options;
  options.sceneMargin_mm = 10, options.sceneReserve_mm = 6;
  Live live(poseAt(-70), smallSetup(), options);
  const auto patient = wideCase();
  for (double x_mm = -70; x_mm <= 70; x_mm += 14) {
    const Frame frame = live.frameAt(poseAt(x_mm));
    ASSERT_TRUE(frame);
    EXPECT_LE(greatestDifference(frame->image, freshPicture(*patient, smallSetup(), poseAt(x_mm))), 1) << x_mm;
  }
  EXPECT_GE(live->status().scenesBuilt, 4);
}

/// A beam that resolves 0.5 mm, so that a coarse scene is coarser.
ImagingSetup fineSetup() {
  ImagingSetup setup = smallSetup();
  setup.probe.transmitFNumber = setup.probe.receiveFNumber = 2;
  return setup;
}

double meanDifference(const BModeImage& a, const BModeImage& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.gray.size(); ++i) sum += std::abs(int(a.gray[i]) - int(b.gray[i]));
  return sum / static_cast<double>(a.gray.size());
}

TEST(LiveImaging, AfterAJumpTheFirstImageIsCoarseAndTheImageOfFullQualityFollows) {
  const ImagingSetup setup = fineSetup();
  Live live(poseAt(-60), setup);
  ASSERT_TRUE(live.frameAt(poseAt(-60)));
  live.settle();
  const int scenes = live->status().scenesBuilt;
  std::uint64_t before = live->latest()->number;
  live->setPose(poseAt(50));
  ASSERT_TRUE(live.until([&] { return live->latest()->number > before; }));
  live.settle();
  const auto patient = wideCase();
  const BModeImage own = freshPicture(*patient, setup, poseAt(50));
  const BModeImage former = freshPicture(*patient, setup, poseAt(-60));
  std::vector<Frame> made;
  for (const Frame& frame : live->cine(1e9))
    if (frame->number > before) made.push_back(frame);
  ASSERT_GE(made.size(), 2U);
  EXPECT_TRUE(made.front()->isCoarse);
  EXPECT_EQ(made.front()->patientFromProbe, poseAt(50)) << "no image of another position in between";
  EXPECT_LT(meanDifference(made.front()->image, own), 0.3 * meanDifference(former, own));
  EXPECT_FALSE(made.back()->isCoarse);
  EXPECT_LE(greatestDifference(made.back()->image, own), 1);
  EXPECT_EQ(live->status().scenesBuilt, scenes + 2) << "a small one and one with room to move; no coarse one counts";
}

/// The image before the jump has no part in the image, neither by persistence nor as another angle.
TEST(LiveImaging, TheFirstImageAfterAJumpHasNothingOfTheImageBefore) {
  ImagingSetup setup = smallSetup();
  setup.settings.persistence = 0.8, setup.settings.compoundingAngles = 3;
  const auto firstAt = [&](double fromX_mm) {
    Live live(poseAt(fromX_mm), setup);
    EXPECT_TRUE(live.frameAt(poseAt(fromX_mm)));
    live.settle();
    live->setPose(poseAt(50));
    EXPECT_TRUE(live.until([&] { return live->latest()->patientFromProbe == poseAt(50); }));
    for (const Frame& frame : live->cine(1e9))
      if (frame->patientFromProbe == poseAt(50)) return frame;
    return Frame();
  };
  const Frame one = firstAt(-60), other = firstAt(-13);
  ASSERT_TRUE(one && other && one->isCoarse && other->isCoarse);
  EXPECT_EQ(greatestDifference(one->image, other->image), 0);
}

TEST(LiveImaging, TheNextSceneIsThereBeforeTheProbeLeaves) {
  Live live;
  ASSERT_TRUE(live.frameAt(poseAt(0)));
  live.settle();
  const int scenes = live->status().scenesBuilt;
  ASSERT_TRUE(live.frameAt(poseAt(8)));  // less than 9 mm left of 15
  ASSERT_TRUE(live.until([&] { return live->status().scenesBuilt == scenes + 1; }));
  live.settle();
  EXPECT_EQ(live->status().state, LiveState::Imaging);
  ASSERT_TRUE(live.frameAt(poseAt(20)));  // beyond the first
}

TEST(LiveImaging, FreezingKeepsTheFrame) {
  Live live;
  ASSERT_TRUE(live.frameAt(poseAt(0)));
  std::atomic<bool> stop{false};
  std::thread hand([&] {
    for (int i = 0; !stop; ++i) live->setPose(poseAt(0.001 * i));
  });
  live->setFrozen(true);
  const Frame frozen = live->latest();
  std::this_thread::sleep_for(50ms);
  EXPECT_EQ(live->latest(), frozen);
  EXPECT_EQ(live->status().state, LiveState::Frozen);
  stop = true;
  hand.join();
  live->setPose(poseAt(4));
  std::this_thread::sleep_for(20ms);
  EXPECT_EQ(live->latest(), frozen);
  live->setFrozen(false);
  EXPECT_TRUE(live.until([&] { return live->latest()->patientFromProbe == poseAt(4); }));
  // Images of the same place may follow before the cine is read.
  const std::vector<Frame> cine = live->cine(1e9);
  const auto next = std::ranges::find(cine, frozen) + 1;
  ASSERT_LT(next, cine.end());
  EXPECT_EQ((*next)->number, frozen->number + 1);
  EXPECT_EQ((*next)->patientFromProbe, poseAt(4));
}

TEST(LiveImaging, CineIsBoundedAndItsFramesOutliveEverything) {
  std::vector<Frame> cine;
  {
    LiveOptions options;
    options.cineBytes = 10 * (128 * 96 + 4096);
    Live live(poseAt(0), smallSetup(), options);
    ASSERT_TRUE(live.frameAt(poseAt(0)));
    EXPECT_EQ(live->cine(1e9).size(), live->latest()->number);
    for (int i = 1; i <= 40; ++i) ASSERT_TRUE(live.frameAt(poseAt(0.1 * i)));
    cine = live->cine(1e9);
    EXPECT_GE(cine.size(), 5u);
    EXPECT_LE(cine.size(), 12u);
    EXPECT_EQ(cine.back(), live->latest());
    EXPECT_EQ(live->cine(0).size(), 1u);
    for (std::size_t i = 1; i < cine.size(); ++i) {
      EXPECT_EQ(cine[i]->number, cine[i - 1]->number + 1);
      EXPECT_GT(cine[i]->time_s, cine[i - 1]->time_s);
    }
    // A frame that somebody holds is not painted over.
    const std::vector<std::uint8_t> before = cine.front()->image.gray;
    for (int i = 1; i <= 30; ++i) ASSERT_TRUE(live.frameAt(poseAt(-0.1 * i)));
    EXPECT_EQ(cine.front()->image.gray, before);
  }
  const auto patient = wideCase();
  const Frame& kept = cine.back();
  EXPECT_LE(greatestDifference(kept->image, freshPicture(*patient, smallSetup(), kept->patientFromProbe)), 1);
}

TEST(LiveImaging, FramesAreUsedAgain) {
  LiveOptions options;
  options.cineBytes = 1;
  Live live(poseAt(0), smallSetup(), options);
  std::set<const std::uint8_t*> buffers;
  for (int i = 0; i < 60; ++i) {
    const Frame frame = live.frameAt(poseAt(0.05 * i));
    ASSERT_TRUE(frame);
    buffers.insert(frame->image.gray.data());
  }
  EXPECT_LE(buffers.size(), 6u);
}

TEST(LiveImaging, EnvelopesComeWhereAskedFor) {
  LiveOptions options;
  options.keepEnvelopes = true;
  Live live(poseAt(0), smallSetup(), options);
  for (const double x_mm : {0.0, 1.0, 2.0, 3.0}) {
    const Frame frame = live.frameAt(poseAt(x_mm));
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->envelope.amplitude.size(), 48u * 200u);
  }
}

TEST(LiveImaging, ABadSetupIsRefusedAndTheOldGoesOn) {
  Live live;
  ASSERT_TRUE(live.frameAt(poseAt(0)));
  ImagingSetup bad = smallSetup();
  bad.settings.gain_dB = 1000;
  const auto refused = live->setSetup(bad);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("gain_dB"));
  bad = smallSetup();
  bad.engine = "magic";
  EXPECT_FALSE(live->setSetup(bad));
  EXPECT_EQ(live.frameAt(poseAt(1))->setup->settings.gain_dB, 0);
}

TEST(LiveImaging, SetupsAreTakenOverWithTheirScene) {
  Live live;
  ASSERT_TRUE(live.frameAt(poseAt(0)));
  ImagingSetup setup = smallSetup();
  const auto patient = wideCase();
  const auto taken = [&] {
    Frame frame;
    EXPECT_TRUE(live->setSetup(setup));
    EXPECT_TRUE(live.until([&] {
      frame = live->latest();
      return frame->setup->settings.gain_dB == setup.settings.gain_dB &&
             frame->setup->settings.depth_mm == setup.settings.depth_mm &&
             frame->setup->tissues.tissues[kVein].echogenicity_dB == setup.tissues.tissues[kVein].echogenicity_dB &&
             frame->setup->probe.name == setup.probe.name && frame->setup->engine == setup.engine && !frame->isCoarse;
    }));
    EXPECT_LE(greatestDifference(frame->image, freshPicture(*patient, setup, poseAt(0))), 1);
  };
  live.settle();
  const int scenes = live->status().scenesBuilt;
  setup.settings.gain_dB = 6;
  taken();
  EXPECT_EQ(live->status().scenesBuilt, scenes) << "gain needs no scene";
  setup.tissues.tissues[kVein].echogenicity_dB += 30;
  taken();
  EXPECT_GT(live->status().scenesBuilt, scenes);
  setup.settings.depth_mm = 60;
  taken();
  setup.engine = "reference";
  taken();
  setup.probe = *loadProbe("linear");
  taken();
  setup.probe = *loadProbe("curvilinear");
  setup.settings = smallSetup().settings;
  setup.settings.depth_mm = 80, setup.settings.frequency_MHz = setup.probe.defaultFrequency_MHz;
  setup.settings.focus_mm = setup.probe.defaultFocus_mm, setup.engine = "cpu";
  taken();
}

TEST(LiveImaging, OutsideThePatientIsBlackAndComesBack) {
  Live live;
  ASSERT_TRUE(live.frameAt(poseAt(0)));
  const Frame outside = live.frameAt(poseAt(1000));
  ASSERT_TRUE(outside);
  EXPECT_EQ(std::ranges::count(outside->image.gray, 0), 128 * 96);
  ASSERT_TRUE(live.until([&] { return live->status().state == LiveState::Outside; }));
  const Frame back = live.frameAt(poseAt(2));
  ASSERT_TRUE(back);
  EXPECT_LE(greatestDifference(back->image, freshPicture(*wideCase(), smallSetup(), poseAt(2))), 1);
  ASSERT_TRUE(live.until([&] { return live->status().state == LiveState::Imaging; }));
}

TEST(LiveImaging, StartsOutside) {
  Live live(poseAt(1000));
  ASSERT_TRUE(live.until([&] { return live->latest() != nullptr; }));
  EXPECT_EQ(std::ranges::count(live->latest()->image.gray, 0), 128 * 96);
}

TEST(LiveImaging, PosesThatAreNoneAreIgnored) {
  Live live;
  ASSERT_TRUE(live.frameAt(poseAt(0)));
  Transform sick = poseAt(1);
  sick.offset.y = NAN;
  live->setPose(sick);
  sick = poseAt(1);
  sick.linear.column[0] = sick.linear.column[0] * 3;
  live->setPose(sick);
  EXPECT_TRUE(live.frameAt(poseAt(2)));
}

TEST(LiveImaging, GoesAtAnyMoment) {
  const auto patient = wideCase();
  for (int i = 0; i < 20; ++i) {
    auto live = LiveImaging::make(patient, smallSetup(), poseAt(0));
    ASSERT_TRUE(live);
    std::this_thread::sleep_for(std::chrono::microseconds(700 * i));
    (*live)->setPose(poseAt(40 * (i % 3)));
    if (i % 2) std::this_thread::sleep_for(std::chrono::microseconds(300 * i));
  }
}

TEST(LiveImaging, InTheBackgroundItComesBehindOthers) {
  for (const bool background : {false, true}) {
    LiveOptions options;
    options.background = background;
    Live live(poseAt(0), smallSetup(), options);
    constexpr int kUnknown = 100;  // beyond -20 to 19
    std::atomic<int> nice{kUnknown};
    live->setFrameListener([&] { nice = getpriority(PRIO_PROCESS, id_t(gettid())); });
    ASSERT_TRUE(live.until([&] { return nice != kUnknown && live->latest(); }));
    live->setFrameListener({});
    EXPECT_EQ(nice > getpriority(PRIO_PROCESS, id_t(gettid())), background);
  }
}

TEST(LiveImaging, CountsPicturesOfTheLastSecond) {
  Live live;
  ASSERT_TRUE(live.frameAt(poseAt(0)));
  for (int i = 1; i <= 20; ++i) live.frameAt(poseAt(0.1 * i));
  EXPECT_GE(live->imagesPerSecond(), 1);
  std::this_thread::sleep_for(1100ms);
  EXPECT_EQ(live->imagesPerSecond(), 0);
}

TEST(LiveImaging, RefusesWhatItCannotImage) {
  const auto refusal = [](std::shared_ptr<const PatientCase> patient, const ImagingSetup& setup,
                          const Transform& pose) {
    const auto live = LiveImaging::make(std::move(patient), setup, pose);
    return live ? std::string() : live.error().message;
  };
  EXPECT_THAT(refusal(nullptr, smallSetup(), poseAt(0)), HasSubstr("no case"));
  auto torn = std::make_shared<PatientCase>(*wideCase());
  torn->labels.geometry.origin_mm.x += 10;
  EXPECT_THAT(refusal(torn, smallSetup(), poseAt(0)), HasSubstr("grids"));
  ImagingSetup bad = smallSetup();
  bad.settings.depth_mm = -1;
  EXPECT_THAT(refusal(wideCase(), bad, poseAt(0)), HasSubstr("depth_mm"));
  Transform sick = poseAt(0);
  sick.linear.column[2] = {};
  EXPECT_THAT(refusal(wideCase(), smallSetup(), sick), HasSubstr("pose"));
}

TEST(LiveImaging, AtRestNoPicturesAreMadeAndTheSameComeAfterwards) {
  Live live;
  const Frame before = live.frameAt(poseAt(0));
  ASSERT_TRUE(before);
  live.settle();
  live->setPaused(true);
  const int scenes = live->status().scenesBuilt;
  live->setPose(poseAt(4));
  std::this_thread::sleep_for(100ms);
  EXPECT_EQ(live->latest()->patientFromProbe, poseAt(0)) << "the last picture stays";
  EXPECT_EQ(live->status().scenesBuilt, scenes);
  EXPECT_FALSE(live->status().buildingScene);
  live->setPaused(false);
  ASSERT_TRUE(live.until([&] { return live->latest()->patientFromProbe == poseAt(4) && !live->latest()->isCoarse; }));
  EXPECT_GT(live->status().scenesBuilt, scenes) << "its scene had been given back";
  live->setPose(poseAt(0));
  const Frame again = live.frameAt(poseAt(0));
  ASSERT_TRUE(again);
  EXPECT_EQ(greatestDifference(before->image, again->image), 0);
}

TEST(LiveImaging, BegunAtRestItMakesItsFirstPictureWhenWoken) {
  LiveOptions options;
  options.paused = true;
  Live live(poseAt(0), smallSetup(), options);
  std::this_thread::sleep_for(100ms);
  EXPECT_EQ(live->latest(), nullptr);
  EXPECT_EQ(live->status().scenesBuilt, 0);
  live->setPaused(false);
  EXPECT_TRUE(live.until([&] { return live->latest() != nullptr; }));
}

TEST(LiveImaging, RestAndWakingInQuickSuccessionLeaveAPicture) {
  Live live;
  for (int i = 0; i < 60; ++i) {
    live->setPose(poseAt(0.5 * i));
    live->setPaused(i % 2 == 0);
    if (i % 7 == 0) std::this_thread::sleep_for(5ms);
  }
  ASSERT_TRUE(live.frameAt(poseAt(29.5)));
}

}  // namespace
}  // namespace insonate
