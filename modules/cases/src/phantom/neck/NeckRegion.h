#pragma once

#include "Anatomy.h"
#include "phantom/Region.h"

namespace insonate::phantom {

/// Makes a neck from hyoid to manubrium, or the region below the right clavicle (NeckParameters::chest).
Region makeRegion(const NeckParameters& parameters, std::uint32_t seed);

}  // namespace insonate::phantom
