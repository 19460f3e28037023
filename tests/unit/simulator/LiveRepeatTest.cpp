#include "LiveProbe.h"
#include "support/Allocations.h"

#include <numbers>

namespace insonate {
namespace {

using namespace std::chrono_literals;
using test::Frame;
using test::Live;

struct Manner {
  const char* name;
  const char* model;
  bool pulsating, keepsMesh;
  double persistence;
};

class LiveRepeat : public testing::TestWithParam<Manner> {};

/// In a circle: deeper and less deep, from side to side, tilted.
std::vector<Transform> presses() {
  constexpr int kSteps = 12;
  std::vector<Transform> poses;
  for (int step = 0; step < kSteps; ++step) {
    const double turn = 2 * std::numbers::pi * step / kSteps;
    poses.push_back(*patientFromProbe({1.5 * std::sin(turn), 2.5 + 1.5 * std::cos(turn), 0},
                                      {0.1 * std::sin(turn), 1, 0.05 * std::cos(turn)}, {1, 0, 0}));
  }
  return poses;
}

/// Each pose, and what its tissue goes through until it rests; with pulsation, a few images of it.
void pressAll(Live& live, const std::vector<Transform>& poses, bool pulsating) {
  for (const Transform& pose : poses) {
    const Frame first = live.frameAt(pose);
    ASSERT_TRUE(first);
    ASSERT_TRUE(live.until([&] {
      const Frame frame = live->latest();
      return pulsating ? frame->number >= first->number + 3 : frame->press.settled;
    }));
  }
}

TEST_P(LiveRepeat, AWholePressedFrameAllocatesNothingInAnyThread) {
  const Manner& manner = GetParam();
  ImagingSetup setup = test::smallSetup();
  setup.mechanics.model = manner.model;
  setup.mechanics.settings.mesh_mm = 1;
  setup.settings.persistence = manner.persistence;
  LiveOptions options;
  options.workAhead = false;  // scenes to come are made of memory
  options.pulsating = manner.pulsating;
  options.cineBytes = 300'000;  // some frames, so that they are soon used again
  const std::vector<Transform> poses = presses();
  Live live(poses.front(), setup, options);
  live->setKeepMesh(manner.keepsMesh);
  live.frameAt(poses.front());
  live.settle();
  for (int round = 0; round < 4; ++round) pressAll(live, poses, manner.pulsating);
  live.settle();
  const std::uint64_t number = live->latest()->number;
  const int scenes = live->status().scenesBuilt;
  const long before = test::allocations();
  pressAll(live, poses, manner.pulsating);
  const long after = test::allocations();
  EXPECT_EQ(after - before, 0);
  EXPECT_GE(live->latest()->number, number + poses.size());
  EXPECT_GT(live->latest()->press.force_N, 0) << "it was pressed";
  EXPECT_EQ(live->status().scenesBuilt, scenes) << "all in one scene";
}

INSTANTIATE_TEST_SUITE_P(All, LiveRepeat,
                         testing::Values(Manner{"elastic", "elastic", false, false, 0.5},
                                         Manner{"pulsating", "elastic", true, false, 0},
                                         Manner{"mesh", "elastic", false, true, 0},
                                         Manner{"column", "column", true, true, 0.5}),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace insonate
