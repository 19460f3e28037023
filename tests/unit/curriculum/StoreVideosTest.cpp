#include "StoreRig.h"

#include <insonate/curriculum/VideoQueue.h>

namespace insonate::test {
namespace {

using Stage = VideoState::Stage;
using ::testing::HasSubstr;

class StoreVideos : public OnBoth {
 protected:
  void SetUp() override {
    OnBoth::SetUp();
    if (!rig) return;
    rig->services.recordings = rig->folder / "recordings";
    school.emplace(rig->open());
    attempt = keepAttempt(school->as(school->anna)).id;
  }
  VideoState state() const { return valueOf(AttemptVideos(school->as(school->anna)).state(attempt)); }
  void request(const std::string& of) const { succeed(AttemptVideos(school->as(school->anna)).request(of)); }

  std::optional<School> school;
  std::string attempt;
};
INSONATE_ON_BOTH(StoreVideos);

TEST_P(StoreVideos, OneServerMakesAVideoOnce) {
  const VideoQueue first(school->store, "first"), second(school->store, "second");
  EXPECT_EQ(state().stage, Stage::NotRequested);
  EXPECT_FALSE(valueOf(first.takeNext())) << "it was not requested";
  request(attempt);
  request(attempt);
  EXPECT_EQ(state().stage, Stage::Waiting);
  EXPECT_EQ(valueOf(first.waiting()), 1);
  const auto taken = valueOf(first.takeNext());
  ASSERT_TRUE(taken);
  EXPECT_EQ(taken->attempt, attempt);
  EXPECT_EQ(taken->recording, rig->folder / "recordings" / (attempt + ".attempt"));
  EXPECT_FALSE(valueOf(second.takeNext())) << "the first has it";
  rig->pass(40 * kSecond_us);
  EXPECT_TRUE(valueOf(first.reportProgress(attempt, 0.25)));
  EXPECT_EQ(state().stage, Stage::Making);
  EXPECT_DOUBLE_EQ(state().fraction, 0.25);
  EXPECT_EQ(state().taken_us, 40 * kSecond_us);
  request(attempt);
  EXPECT_EQ(state().stage, Stage::Making) << "asking again does not begin it again";
  succeed(first.storeResult(attempt, ""));
  EXPECT_EQ(state().stage, Stage::Ended);
  EXPECT_EQ(valueOf(first.waiting()), 0);
  EXPECT_FALSE(valueOf(second.takeNext()));
  request(attempt);
  EXPECT_TRUE(valueOf(second.takeNext())) << "a video that was removed is made again";
}

TEST_P(StoreVideos, AServerThatDiesIsReplacedAndNoLongerCounts) {
  const VideoQueue first(school->store, "first"), second(school->store, "second");
  request(attempt);
  ASSERT_TRUE(valueOf(first.takeNext()));
  rig->pass(100 * kSecond_us);
  EXPECT_TRUE(valueOf(first.reportProgress(attempt, 0.5)));
  rig->pass(100 * kSecond_us);
  EXPECT_FALSE(valueOf(second.takeNext())) << "the first has reported";
  rig->pass(30 * kSecond_us);
  ASSERT_TRUE(valueOf(second.takeNext()));
  EXPECT_DOUBLE_EQ(state().fraction, 0) << "the second begins anew";
  EXPECT_FALSE(valueOf(first.reportProgress(attempt, 0.75)));
  succeed(first.storeResult(attempt, "a reason of the first"));
  EXPECT_EQ(state().stage, Stage::Making);
  succeed(second.storeResult(attempt, "The case is not here."));
  EXPECT_EQ(state().stage, Stage::Ended);
  EXPECT_EQ(state().why, "The case is not here.");
}

TEST_P(StoreVideos, AServerThatEndsGivesItsVideoBack) {
  const VideoQueue first(school->store, "first"), second(school->store, "second");
  request(attempt);
  ASSERT_TRUE(valueOf(first.takeNext()));
  succeed(second.release(attempt));
  EXPECT_EQ(state().stage, Stage::Making) << "it is not the second's";
  succeed(first.release(attempt));
  EXPECT_EQ(state().stage, Stage::Waiting);
  EXPECT_TRUE(valueOf(second.takeNext()));
}

TEST_P(StoreVideos, AVideoThatStopsTheServerIsGivenUp) {
  const auto takes = [this](const char* server) {
    rig->pass(130 * kSecond_us);  // the former server no longer counts
    return valueOf(VideoQueue(school->store, server).takeNext()).has_value();
  };
  request(attempt);
  const VideoQueue quiet(school->store, "quiet");
  for (int i = 0; i < 5; ++i) {
    ASSERT_TRUE(valueOf(quiet.takeNext())) << "a server that ends as it should is no try";
    succeed(quiet.release(attempt));
  }
  for (const char* server : {"first", "second", "third"}) EXPECT_TRUE(takes(server)) << server;
  rig->pass(kSecond_us);
  const std::string later = keepAttempt(school->as(school->anna)).id;
  request(later);
  rig->pass(130 * kSecond_us);
  const auto next = valueOf(VideoQueue(school->store, "fourth").takeNext());
  ASSERT_TRUE(next);
  EXPECT_EQ(next->attempt, later) << "the next video is not held up";
  EXPECT_EQ(state().stage, Stage::Ended);
  EXPECT_THAT(state().why, HasSubstr("The video cannot be made: the server stopped three times"));
  succeed(VideoQueue(school->store, "fourth").storeResult(later, ""));
  EXPECT_FALSE(takes("fifth"));
  request(attempt);
  EXPECT_EQ(state().stage, Stage::Waiting) << "a user may try it again";
  EXPECT_TRUE(takes("sixth"));
}

TEST_P(StoreVideos, TheOneAskedForFirstIsMadeFirst) {
  request(attempt);
  rig->pass(kSecond_us);
  const std::string later = keepAttempt(school->as(school->anna)).id;
  request(later);
  EXPECT_EQ(valueOf(AttemptVideos(school->as(school->anna)).state(later)).before, 1);
  const VideoQueue queue(school->store, "first");
  EXPECT_EQ(valueOf(queue.takeNext())->attempt, attempt);
  EXPECT_EQ(valueOf(AttemptVideos(school->as(school->anna)).state(later)).before, 1);
  EXPECT_EQ(valueOf(queue.takeNext())->attempt, later);
}

}  // namespace
}  // namespace insonate::test
