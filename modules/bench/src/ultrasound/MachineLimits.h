#pragma once

namespace insonate::bench {

/// Measured limits of the processor with its widest vector instructions. Each limit is the best of many short runs, so
/// that other running programs have little effect.
struct MachineLimits {
  double multiplyAdd_GFLOPs = 0;  ///< rate of multiply-adds in single precision, on registers
  double cache_GBps = 0;  ///< bandwidth of a = b + s c (two reads, one write) on arrays that fit the second-level cache
  double memory_GBps = 0;  ///< bandwidth of a = b + s c on arrays far larger than any cache (STREAM triad)
};

/// Measures the limits with this number of threads; takes `seconds` in total.
MachineLimits measureMachine(int threads, double seconds);

}  // namespace insonate::bench
