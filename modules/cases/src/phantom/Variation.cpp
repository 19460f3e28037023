#include "Variation.h"

#include "Individual.h"

namespace insonate::phantom {

Column varied(Column c, std::uint32_t seed) {
  constexpr double kCell_mm = 30;
  const Individual vary(seed);
  for (auto& [z, v] : c.course.knots()) {
    v[0] += 0.7 * vary(1) + 0.5 * vary.along(2, z, kCell_mm);
    v[1] += 0.6 * vary(3) + 0.5 * vary.along(4, z, kCell_mm);
    v[2] *= 1 + 0.1 * vary(5) + 0.08 * vary.along(6, z, kCell_mm);
    v[3] *= 1 + 0.1 * vary(7) + 0.08 * vary.along(8, z, kCell_mm);
    v[4] += 7 * vary(9) + 5 * vary.along(10, z, kCell_mm);
  }
  return c;
}

Sheet varied(Sheet s, std::uint32_t seed) {
  constexpr double kCell_mm = 30;
  const Individual vary(seed);
  for (auto& [z, v] : s.course.knots()) {
    v[0] += 2 * vary(1) + 1.5 * vary.along(2, z, kCell_mm);
    const double thicker = v[3] * (0.14 * vary(3) + 0.1 * vary.along(4, z, kCell_mm));
    v[1] += thicker + 0.3 * vary.along(5, z, kCell_mm);
    v[2] *= 1 + 0.1 * vary(6) + 0.1 * vary.along(7, z, kCell_mm);
    v[3] += thicker;
  }
  return s;
}

std::array<double, 2> tortuosity_mm(std::uint32_t seed, double z_mm, double amplitude_mm) {
  constexpr double kCell_mm = 22;
  const Individual vary(seed);
  return {amplitude_mm * vary.along(1, z_mm, kCell_mm), amplitude_mm * vary.along(2, z_mm, kCell_mm)};
}

}  // namespace insonate::phantom
