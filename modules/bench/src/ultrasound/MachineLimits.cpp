#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ultrasound/MachineLimits.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h, which includes this file once for each instruction set.
#include "ultrasound/MachineLimits.h"

#include <hwy/aligned_allocator.h>
#include <hwy/highway.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <thread>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace insonate::bench::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Computes independent chains of multiply-adds; returns the number of floating-point operations. `sink` prevents that
/// the compiler removes them.
double chainsTarget(int rounds, float* sink) {
  const hn::ScalableTag<float> d;
  const auto a = hn::Set(d, 0.999F), b = hn::Set(d, 1e-3F);
  // Separate variables, since compilers keep arrays of vectors in memory. Ten chains cover latency times ports.
  auto v0 = hn::Iota(d, 0), v1 = hn::Iota(d, 1), v2 = hn::Iota(d, 2), v3 = hn::Iota(d, 3), v4 = hn::Iota(d, 4);
  auto v5 = hn::Iota(d, 5), v6 = hn::Iota(d, 6), v7 = hn::Iota(d, 7), v8 = hn::Iota(d, 8), v9 = hn::Iota(d, 9);
  for (int r = 0; r < rounds; ++r) {
    v0 = hn::MulAdd(v0, a, b), v1 = hn::MulAdd(v1, a, b), v2 = hn::MulAdd(v2, a, b), v3 = hn::MulAdd(v3, a, b);
    v4 = hn::MulAdd(v4, a, b), v5 = hn::MulAdd(v5, a, b), v6 = hn::MulAdd(v6, a, b), v7 = hn::MulAdd(v7, a, b);
    v8 = hn::MulAdd(v8, a, b), v9 = hn::MulAdd(v9, a, b);
  }
  const auto low = hn::Add(hn::Add(hn::Add(v0, v1), hn::Add(v2, v3)), v4);
  const auto high = hn::Add(hn::Add(hn::Add(v5, v6), hn::Add(v7, v8)), v9);
  *sink += hn::GetLane(hn::SumOfLanes(d, hn::Add(low, high)));
  return 10.0 * 2.0 * double(hn::Lanes(d)) * rounds;
}

void triadTarget(float* HWY_RESTRICT a, const float* HWY_RESTRICT b, const float* HWY_RESTRICT c, std::size_t size) {
  const hn::ScalableTag<float> d;
  const auto s = hn::Set(d, 3.0F);
  for (std::size_t i = 0; i < size; i += hn::Lanes(d))
    hn::Store(hn::MulAdd(s, hn::Load(d, c + i), hn::Load(d, b + i)), d, a + i);
}

}  // namespace insonate::bench::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace insonate::bench {
namespace {

HWY_EXPORT(chainsTarget);
HWY_EXPORT(triadTarget);

using Clock = std::chrono::steady_clock;
constexpr std::size_t kCacheFloats = 1 << 14;   // three arrays of 64 KiB for each thread
constexpr std::size_t kMemoryFloats = 1 << 24;  // three arrays of 64 MiB in total

/// Calls of `task` per second by all threads: the sum of each thread's best rate while all threads run. Uses its own
/// threads, since a pool may run such short work on one thread.
template <class Task>
double bestRate(int threads, double seconds, const Task& task) {
  std::vector<double> best(threads, 0.0);
  const auto measure = [&](int t) {
    const auto begin = Clock::now();
    do {
      const auto start = Clock::now();
      task(t);
      best[t] = std::max(best[t], 1 / std::chrono::duration<double>(Clock::now() - start).count());
    } while (std::chrono::duration<double>(Clock::now() - begin).count() < seconds);
  };
  std::vector<std::thread> helpers;
  for (int t = 1; t < threads; ++t) helpers.emplace_back(measure, t);
  measure(0);
  for (std::thread& helper : helpers) helper.join();
  return std::accumulate(best.begin(), best.end(), 0.0);
}

/// Three arrays, written once so that their pages are mapped.
struct TriadArrays {
  explicit TriadArrays(std::size_t floats)
      : size(floats),
        a(hwy::AllocateAligned<float>(floats)),
        b(hwy::AllocateAligned<float>(floats)),
        c(hwy::AllocateAligned<float>(floats)) {
    std::fill_n(a.get(), size, 0.0F), std::fill_n(b.get(), size, 1.0F), std::fill_n(c.get(), size, 2.0F);
  }
  std::size_t size;
  hwy::AlignedFreeUniquePtr<float[]> a, b, c;
};

}  // namespace

MachineLimits measureMachine(int threads, double seconds) {
  MachineLimits limits;
  constexpr int kRounds = 100000;
  std::vector<float> sinks(std::size_t(threads) * 16);  // one cache line for each thread
  double operations = 0;
  const double chains = bestRate(threads, seconds / 3, [&](int t) {
    const double done = HWY_DYNAMIC_DISPATCH(chainsTarget)(kRounds, &sinks[std::size_t(t) * 16]);
    if (t == 0) operations = done;
  });
  limits.multiplyAdd_GFLOPs = chains * operations / 1e9;

  constexpr int kPasses = 200;
  std::vector<TriadArrays> own;
  own.reserve(threads);
  for (int t = 0; t < threads; ++t) own.emplace_back(kCacheFloats);
  const double cached = bestRate(threads, seconds / 3, [&](int t) {
    for (int pass = 0; pass < kPasses; ++pass)
      HWY_DYNAMIC_DISPATCH(triadTarget)(own[t].a.get(), own[t].b.get(), own[t].c.get(), own[t].size);
  });
  limits.cache_GBps = cached * 3 * sizeof(float) * kCacheFloats * kPasses / 1e9;

  const TriadArrays large(kMemoryFloats);
  const std::size_t share = kMemoryFloats / threads / 64 * 64;
  const double streamed = bestRate(threads, seconds / 3, [&](int t) {
    const std::size_t first = share * t;
    HWY_DYNAMIC_DISPATCH(triadTarget)(large.a.get() + first, large.b.get() + first, large.c.get() + first, share);
  });
  limits.memory_GBps = streamed * 3 * sizeof(float) * double(share) / 1e9;
  return limits;
}

}  // namespace insonate::bench
#endif
