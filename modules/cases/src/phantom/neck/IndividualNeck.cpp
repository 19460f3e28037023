#include "Anatomy.h"
#include "phantom/Individual.h"

#include <algorithm>

namespace insonate::phantom {
namespace {

constexpr double kMeanSkin_mm = 1.6;

}  // namespace

NeckParameters individualNeck(NeckParameters n, std::uint32_t seed) {
  const Individual vary(seed);
  n.seed = hash32(seed ^ 0x6f6eU);
  // Skin of the neck: 1.0 to 2.2 mm.
  n.skin_mm = kMeanSkin_mm + 0.6 * vary(1);
  const double fatter_mm = std::min(0.35 * n.fat_mm, 1.4) * vary(2);
  n.fat_mm += fatter_mm;
  // Variants promise the depth of the vessels, so that the neck below the layers mostly loses the thickness that they
  // gain.
  n.girth_mm = 0.6 * vary(3) - 0.6 * (n.skin_mm - kMeanSkin_mm + fatter_mm);
  n.sternomastoidScale *= 1 + 0.13 * vary(4);
  n.thyroidScale *= 1 + 0.16 * vary(5);
  n.carotidScale *= 1 + 0.06 * vary(6);
  n.bifurcation_z_mm += 2.5 * vary(7);
  for (std::uint32_t s : {0U, 1U}) {
    n.veinWidth[s] *= 1 + 0.06 * vary(10 + s);
    n.veinHeight[s] *= 1 + 0.06 * vary(12 + s);
  }
  n.platysma = {.height = 0.32 + 0.24 * vary(20),
                .halfThickness_mm = 0.52 + 0.2 * vary(21),
                .first = 0.14 + 0.1 * vary(22),
                .last = 1.6 + 0.3 * vary(23),
                .top_z_mm = 46 + 8 * vary(24)};
  return n;
}

}  // namespace insonate::phantom
