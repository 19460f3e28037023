#pragma once

#include "Noise.h"

namespace insonate::phantom {

/// Random differences between people: numbers in [-1, 1] that depend on the person's seed and on the number of the
/// property.
class Individual {
 public:
  explicit Individual(std::uint32_t seed) : seed_(hash32(seed + 0x70657273U)) {}

  /// Returns a uniformly distributed number for the property `of`.
  double operator()(std::uint32_t of) const { return 2 * unitInterval(hash32(seed_ ^ hash32(of))) - 1; }
  /// Returns a number that changes smoothly along the neck, with about one extremum per `cell_mm`.
  double along(std::uint32_t of, double z_mm, double cell_mm) const {
    return smoothNoise({z_mm / cell_mm, 0.5, 0.5}, seed_ ^ hash32(of));
  }

 private:
  std::uint32_t seed_;
};

}  // namespace insonate::phantom
