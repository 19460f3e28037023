#pragma once

#include "Noise.h"

namespace insonate::phantom {

/// Differences between people: numbers of [-1, 1] that follow from a seed and a number for what differs.
class Individual {
 public:
  explicit Individual(std::uint32_t seed) : seed_(hash32(seed + 0x70657273U)) {}

  /// Uniform.
  double operator()(std::uint32_t of) const { return 2 * unitInterval(hash32(seed_ ^ hash32(of))) - 1; }
  /// Changes smoothly along the neck, with one extremum in about a cell.
  double along(std::uint32_t of, double z_mm, double cell_mm) const {
    return smoothNoise({z_mm / cell_mm, 0.5, 0.5}, seed_ ^ hash32(of));
  }

 private:
  std::uint32_t seed_;
};

}  // namespace insonate::phantom
