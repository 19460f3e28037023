#include "DisplaySupport.h"
#include "SpeckleFrame.h"
#include "support/Allocations.h"

#include <gmock/gmock.h>
#include <hwy/targets.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

namespace insonate {
namespace {

class DisplayRepeat : public testing::TestWithParam<const char*> {
 protected:
  Probe probe = *loadProbe(GetParam());
  ImagingSettings settings = [this] {
    ImagingSettings s = settingsFor(probe);
    s.persistence = 0.4;
    s.scanlines = 203;  // no whole number of vectors
    s.samples = 601;
    return s;
  }();
  EnvelopeFrame frame = test::speckleFrame(203, 601, 3, 6, 4, 9);

  /// The second image, so that persistence takes part.
  BModeImage second() const {
    Display live(probe, settings);
    BModeImage image;
    live.process(frame, image);
    live.process(frame, image);
    return image;
  }
};

TEST_P(DisplayRepeat, NothingIsAllocatedPerPicture) {
  Display live(probe, settings);
  BModeImage image;
  live.process(frame, image);
  const long before = test::allocations();
  for (int i = 0; i < 3; ++i) live.process(frame, image);
  EXPECT_EQ(test::allocations() - before, 0);
}

TEST_P(DisplayRepeat, PictureDoesNotDependOnThreads) {
  BModeImage one, four;
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, 4);
  tbb::task_arena(1).execute([&] { one = second(); });
  tbb::task_arena(4).execute([&] { four = second(); });
  EXPECT_EQ(one.gray, four.gray);
}

TEST_P(DisplayRepeat, PictureDoesNotDependOnTheInstructionSet) {
  const BModeImage best = second();
  for (std::int64_t rest = hwy::SupportedTargets(); rest != 0; rest &= rest - 1) {
    const std::int64_t target = rest & -rest;
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(target);
    const BModeImage image = second();
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    int worst = 0;
    for (std::size_t i = 0; i < best.gray.size(); ++i) worst = std::max(worst, std::abs(image.gray[i] - best.gray[i]));
    EXPECT_LE(worst, 1) << hwy::TargetName(target);
  }
}

TEST_P(DisplayRepeat, StagesAreTimed) {
  Display live(probe, settings);
  BModeImage image;
  live.process(frame, image);
  for (const double ms :
       {live.stages().compound, live.stages().compress, live.stages().smooth, live.stages().scanConvert})
    EXPECT_GT(ms, 0);
}

INSTANTIATE_TEST_SUITE_P(Probes, DisplayRepeat, testing::Values("linear", "curvilinear", "phased"),
                         [](const auto& parameter) { return std::string(parameter.param); });

}  // namespace
}  // namespace insonate
