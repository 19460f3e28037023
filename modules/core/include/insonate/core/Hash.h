#pragma once

#include <cstdint>

namespace insonate {

/// 32-bit finalizer with low bias (C. Wellons, "Prospecting for hash functions", 2018). Phantom noise and scatterers
/// compute their random values with it instead of storing them; it uses only operations that shaders have, too.
constexpr std::uint32_t hash32(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x21f0aaadU;
  x ^= x >> 15;
  x *= 0x735a2d97U;
  x ^= x >> 15;
  return x;
}

/// Hash of a lattice node; the seed separates independent fields.
constexpr std::uint32_t hashNode(std::int32_t i, std::int32_t j, std::int32_t k, std::uint32_t seed) {
  return hash32(static_cast<std::uint32_t>(i) * 0x8da6b343U ^ static_cast<std::uint32_t>(j) * 0xd8163841U ^
                static_cast<std::uint32_t>(k) * 0xcb1ab31fU ^ seed);
}

/// Maps a hash to a number that is uniform in [0, 1).
constexpr double unitInterval(std::uint32_t hash) {
  return hash * (1.0 / 4294967296.0);
}

}  // namespace insonate
