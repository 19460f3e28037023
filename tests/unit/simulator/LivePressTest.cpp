#include "LiveProbe.h"

#include <gmock/gmock.h>

#include <random>

namespace insonate {
namespace {

using namespace std::chrono_literals;
using test::Frame;
using test::Live;
using testing::HasSubstr;

/// The face this deep in the skin, over a vein.
Transform pressedBy(double mm, double x_mm = 0) {
  return *patientFromProbe({x_mm, mm - 0.5, 0}, {0, 1, 0}, {1, 0, 0});
}

const Transform kLifted = pressedBy(-1);

ImagingSetup pressSetup(const std::string& model = "elastic") {
  ImagingSetup setup = test::smallSetup();
  setup.mechanics.model = model;
  setup.mechanics.settings.mesh_mm = 1;
  return setup;
}

/// Ratio of the area of all veins in the plane to their area at rest; 1 if nothing was solved.
double veinShare(const LiveFrame& frame) {
  for (const LumenArea& lumen : frame.press.lumens)
    if (lumen.label == kVein) return lumen.area_mm2 / lumen.rest_mm2;
  return 1;
}

/// The image of a pose, when its tissue has come to rest.
Frame settledAt(Live& live, const Transform& pose) {
  live.frameAt(pose);
  Frame frame;
  EXPECT_TRUE(
      live.until([&] { return (frame = live->latest())->patientFromProbe == pose && frame->press.settled; }, 20s));
  return frame;
}

TEST(LiveDeformation, PressingFlattensTheVeinAndReleaseRestoresTheFirstPicture) {
  Live live(kLifted, pressSetup());
  const Frame first = live.frameAt(kLifted);
  live.settle();
  EXPECT_TRUE(first->press.lumens.empty()) << "nothing is solved where nothing touches";
  EXPECT_EQ(first->press.force_N, 0);
  double share = 1.01, force_N = 0;
  for (const double press_mm : {1.0, 2.0, 4.0, 6.0}) {
    const Frame frame = settledAt(live, pressedBy(press_mm));
    EXPECT_LT(veinShare(*frame), share) << press_mm;
    EXPECT_GT(frame->press.force_N, force_N) << press_mm;
    EXPECT_NEAR(frame->press.indentation_mm, press_mm, 0.3);
    share = veinShare(*frame), force_N = frame->press.force_N;
  }
  EXPECT_LT(share, 0.6);
  const Frame last = settledAt(live, kLifted);
  EXPECT_EQ(last->image.gray, first->image.gray);
  EXPECT_TRUE(last->press.lumens.empty());
}

TEST(LiveDeformation, APressedProbeThatIsHeldStillMakesNoMorePictures) {
  Live live(kLifted, pressSetup());
  live.frameAt(kLifted);
  live.settle();
  settledAt(live, pressedBy(3));
  live.settle();
  const Frame frame = live->latest();
  std::this_thread::sleep_for(150ms);
  EXPECT_EQ(live->latest(), frame);
}

TEST(LiveDeformation, AnythingAHandMayDoGivesFinitePictures) {
  Live live(kLifted, pressSetup());
  live.frameAt(kLifted);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> x_mm(-12, 12), press_mm(-4, 14), turn(-0.6, 0.6);
  int pressed = 0;
  for (int i = 0; i < 100; ++i) {
    const Transform pose =
        *patientFromProbe({x_mm(random), press_mm(random), 0}, {turn(random), 1, turn(random)}, {1, 0, turn(random)});
    const Frame frame = live.frameAt(pose);
    ASSERT_TRUE(frame);
    EXPECT_TRUE(std::isfinite(frame->press.force_N)) << i;
    for (const LumenArea& lumen : frame->press.lumens) EXPECT_TRUE(std::isfinite(lumen.area_mm2)) << i;
    pressed += frame->press.force_N > 0;
  }
  EXPECT_GT(pressed, 20);
}

TEST(LiveDeformation, WithPulsationTheVesselsMoveByThemselvesUntilFrozen) {
  Live live(kLifted, pressSetup());
  live.frameAt(kLifted);
  live.settle();
  live->setPulsating(true);
  double low = 2, high = 0;
  std::uint64_t seen = 0;
  EXPECT_TRUE(live.until(
      [&] {
        const Frame frame = live->latest();
        if (!frame->press.lumens.empty()) {
          low = std::min(low, veinShare(*frame)), high = std::max(high, veinShare(*frame));
          seen = std::max(seen, frame->number);
        }
        return high > low + 0.02 && seen > 15;
      },
      20s))
      << low << " to " << high;
  live->setFrozen(true);
  const Frame frozen = live->latest();
  std::this_thread::sleep_for(100ms);
  EXPECT_EQ(live->latest(), frozen);
  live->setFrozen(false);
  EXPECT_TRUE(live.until([&] { return live->latest()->number > frozen->number + 3; }, 20s));
  live->setPulsating(false);
  EXPECT_TRUE(live.until([&] { return live->latest()->press.lumens.empty(); }, 20s));
  live.settle();
  const Frame still = live->latest();
  std::this_thread::sleep_for(100ms);
  EXPECT_EQ(live->latest(), still);
}

TEST(LiveDeformation, WithPulsationAndNoVesselInThePlaneNothingIsDone) {
  auto patient = std::make_shared<PatientCase>(*test::wideCase());
  for (auto& label : patient->labels.voxels) label = label == kVein ? std::uint8_t{kSoftTissue} : label;
  LiveOptions options;
  options.pulsating = true;
  Live live(kLifted, pressSetup(), options, patient);
  live.frameAt(kLifted);
  live.settle();
  const Frame frame = live->latest();
  std::this_thread::sleep_for(150ms);
  EXPECT_EQ(live->latest(), frame);
}

TEST(LiveDeformation, PostureFillsTheVein) {
  Live live(kLifted, pressSetup());
  live.frameAt(kLifted);
  live.settle();
  const auto shareAt = [&](double tilt_deg) {
    EXPECT_TRUE(live->setPhysiology({.tilt_deg = tilt_deg}));
    EXPECT_TRUE(live.until(
        [&] {
          const Frame frame = live->latest();
          return frame->press.settled && frame->press.lumens.empty() == (tilt_deg == 0);
        },
        20s));
    live.settle();
    return veinShare(*live->latest());
  };
  EXPECT_GT(shareAt(15), 1.05);
  EXPECT_EQ(shareAt(0), 1);
  EXPECT_LT(shareAt(-15), 0.95);
}

TEST(LiveDeformation, TissueStaysWhereItIsWhenSettingsChange) {
  Live live(kLifted, pressSetup());
  live.frameAt(kLifted);
  live.settle();
  const double share = veinShare(*settledAt(live, pressedBy(4)));
  ImagingSetup louder = pressSetup();
  louder.settings.gain_dB = 6;
  ASSERT_TRUE(live->setSetup(louder));
  Frame frame;
  ASSERT_TRUE(live.until([&] { return (frame = live->latest())->setup->settings.gain_dB == 6; }, 20s));
  EXPECT_NEAR(veinShare(*frame), share, 0.02) << "already in the first picture";
}

TEST(LiveDeformation, ModelsCanBeChangedWhileItIsPressed) {
  Live live(kLifted, pressSetup());
  live.frameAt(kLifted);
  const Frame elastic = settledAt(live, pressedBy(4));
  const auto with = [&](const std::string& model) {
    EXPECT_TRUE(live->setSetup(pressSetup(model)));
    Frame frame;
    EXPECT_TRUE(live.until([&] { return (frame = live->latest())->setup->mechanics.model == model; }, 20s));
    return frame;
  };
  const Frame column = with("column");
  EXPECT_GT(column->press.force_N, 0);
  EXPECT_NE(column->image.gray, elastic->image.gray);
  const Frame none = with("none");
  EXPECT_EQ(none->press.force_N, 0);
  EXPECT_TRUE(none->press.lumens.empty());
  EXPECT_NE(none->image.gray, elastic->image.gray);
}

TEST(LiveDeformation, TheMeshComesOnlyWhereAskedFor) {
  Live live(kLifted, pressSetup());
  live.frameAt(kLifted);
  EXPECT_TRUE(settledAt(live, pressedBy(3))->press.mesh.nodes.empty());
  live->setKeepMesh(true);
  const Frame frame = live.frameAt(pressedBy(3.5));
  const TissueMesh& mesh = frame->press.mesh;
  ASSERT_GT(mesh.columns, 10);
  EXPECT_EQ(mesh.nodes.size(), std::size_t(mesh.columns) * mesh.rows);
  EXPECT_EQ(mesh.pressure_kPa.size(), std::size_t(mesh.columns - 1) * (mesh.rows - 1));
  live->setKeepMesh(false);
  EXPECT_TRUE(live.frameAt(pressedBy(3))->press.mesh.nodes.empty());
}

TEST(LiveDeformation, OutsideThePatientNothingIsPressed) {
  Live live(kLifted, pressSetup());
  live.frameAt(kLifted);
  settledAt(live, pressedBy(4));
  const Frame outside = live.frameAt(pressedBy(4, 1000));
  EXPECT_EQ(outside->press.force_N, 0);
  EXPECT_TRUE(outside->press.lumens.empty());
  EXPECT_LT(veinShare(*settledAt(live, pressedBy(4))), 0.9);
}

TEST(LiveDeformation, NonsenseIsRefused) {
  Live live(kLifted, pressSetup());
  const auto refused = live->setPhysiology({.systolic_mmHg = 50, .diastolic_mmHg = 90});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("systolic"));
  ImagingSetup bad = pressSetup("jelly");
  const auto model = live->setSetup(bad);
  ASSERT_FALSE(model);
  EXPECT_THAT(model.error().message, HasSubstr("jelly"));
  LiveOptions options;
  options.physiology.tilt_deg = NAN;
  EXPECT_FALSE(LiveImaging::make(test::wideCase(), pressSetup(), kLifted, options));
}

}  // namespace
}  // namespace insonate
