#include "Anatomy.h"

#include <insonate/core/Hash.h>

namespace insonate::phantom {

std::vector<Structure> makeAnatomy(const NeckParameters& parameters, std::uint32_t seed) {
  std::vector<Structure> structures;
  // Vessels are drawn before bone, so that the vertebral artery makes its own foramina.
  addAirway(structures, hash32(seed + 1));
  addVessels(structures, parameters, hash32(seed + 2));
  addSpine(structures, hash32(seed + 3));
  addGirdle(structures, parameters, hash32(seed + 4));
  addNervesAndGlands(structures, parameters, hash32(seed + 5));
  addMuscles(structures, parameters, hash32(seed + 6));
  if (parameters.chest) addChestMuscles(structures, hash32(seed + 7));
  return structures;
}

}  // namespace insonate::phantom
