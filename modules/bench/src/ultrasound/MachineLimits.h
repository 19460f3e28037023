#pragma once

namespace insonate::bench {

/// Limits of the processor, measured with its widest vectors: the best of many short runs, so that other programs on
/// the machine hardly matter.
struct MachineLimits {
  double multiplyAdd_GFLOPs = 0;  ///< single precision, on registers
  double cache_GBps = 0;          ///< a = b + s c on arrays that fit the second-level cache (read, read, write)
  double memory_GBps = 0;         ///< the same on arrays far larger than any cache (STREAM triad)
};

/// `seconds` is shared by the three kernels.
MachineLimits measureMachine(int threads, double seconds);

}  // namespace insonate::bench
