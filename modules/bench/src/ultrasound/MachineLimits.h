#pragma once

namespace insonate::bench {

/// Limits of the processor, measured with its widest vectors. Each limit is the best of many short runs, so that other
/// programs on the machine have little effect.
struct MachineLimits {
  double multiplyAdd_GFLOPs = 0;  ///< single precision, on registers
  double cache_GBps = 0;          ///< a = b + s c on arrays that fit the second-level cache (read, read, write)
  double memory_GBps = 0;         ///< like cache_GBps, on arrays far larger than any cache (STREAM triad)
};

/// Measures the limits in `seconds`, which the three kernels share.
MachineLimits measureMachine(int threads, double seconds);

}  // namespace insonate::bench
