#pragma once

#include <cstdint>

namespace insonate {

/// 32-bit hash finalizer with low bias (C. Wellons, "Prospecting for hash functions", 2018). The program computes the
/// noise of the built-in necks and the random values of ultrasound scatterers with this function instead of storing
/// them. The function uses only operations that shaders also have.
constexpr std::uint32_t hash32(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x21f0aaadU;
  x ^= x >> 15;
  x *= 0x735a2d97U;
  x ^= x >> 15;
  return x;
}

/// Returns the hash of the lattice node with the indices i, j, k. Different seeds give independent random fields.
constexpr std::uint32_t hashNode(std::int32_t i, std::int32_t j, std::int32_t k, std::uint32_t seed) {
  return hash32(static_cast<std::uint32_t>(i) * 0x8da6b343U ^ static_cast<std::uint32_t>(j) * 0xd8163841U ^
                static_cast<std::uint32_t>(k) * 0xcb1ab31fU ^ seed);
}

/// Maps a hash to a number that is uniform in [0, 1).
constexpr double unitInterval(std::uint32_t hash) {
  return hash * (1.0 / 4294967296.0);
}

}  // namespace insonate
