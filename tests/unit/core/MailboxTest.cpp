#include <insonate/core/Mailbox.h>

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

namespace insonate {
namespace {

TEST(Mailbox, IsEmptyAtFirst) {
  Mailbox<int> box;
  EXPECT_FALSE(box.takeLatest());
}

TEST(Mailbox, HandsOutTheLatestOnce) {
  Mailbox<int> box;
  for (int i = 0; i < 1000; ++i) box.post(i);
  EXPECT_EQ(box.takeLatest(), 999);
  EXPECT_FALSE(box.takeLatest());
  box.post(7);
  EXPECT_EQ(box.takeLatest(), 7);
}

TEST(Mailbox, KeepsNothingOfWhatWasTaken) {
  Mailbox<std::shared_ptr<int>> box;
  auto value = std::make_shared<int>(1);
  const std::weak_ptr<int> watched = value;
  box.post(std::move(value));
  value = box.takeLatest().value();
  value.reset();
  EXPECT_TRUE(watched.expired());
}

/// A value whose halves must agree: a torn one would show.
struct Pair {
  long a = 0, b = 0;
};

TEST(Mailbox, ManyWritersNeitherTearNorLoseTheLast) {
  Mailbox<Pair> box;
  constexpr int kWriters = 4;
  constexpr long kEach = 20'000;
  std::atomic<int> left{kWriters};
  std::vector<std::thread> writers;
  for (int w = 0; w < kWriters; ++w)
    writers.emplace_back([&, w] {
      for (long i = 1; i <= kEach; ++i) box.post({w * kEach + i, -(w * kEach + i)});
      --left;
    });
  std::vector<long> last(kWriters, 0);
  Pair latest;
  const auto look = [&] {
    const auto value = box.takeLatest();
    if (!value) return;
    latest = *value;
    ASSERT_EQ(value->a, -value->b);
    const long writer = (value->a - 1) / kEach;
    ASSERT_GT(value->a, last[writer]) << "older than one that was taken before";
    last[writer] = value->a;
  };
  while (left > 0) look();
  for (std::thread& writer : writers) writer.join();
  look();
  EXPECT_EQ(latest.a % kEach, 0) << "the last value is the last of some writer";
  EXPECT_FALSE(box.takeLatest());
}

}  // namespace
}  // namespace insonate
