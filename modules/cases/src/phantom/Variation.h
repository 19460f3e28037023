#pragma once

#include "Shapes.h"

#include <array>

namespace insonate::phantom {

/// Returns a muscle or organ as it is in one person: slightly shifted and scaled, by amounts that vary along the neck.
/// The superficial face of a sheet keeps its depth.
Column varied(Column usual, std::uint32_t seed);
Sheet varied(Sheet usual, std::uint32_t seed);

/// Returns a vessel's deviation from its usual course at a level, {lateral, posterior} mm, since no vessel is straight.
std::array<double, 2> tortuosity_mm(std::uint32_t seed, double z_mm, double amplitude_mm);

}  // namespace insonate::phantom
