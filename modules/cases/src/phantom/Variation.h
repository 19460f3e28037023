#pragma once

#include "Anatomy.h"

namespace insonate::phantom {

/// One person's neck, varied about a variant's default values within the limits of the variant's description.
NeckParameters individualNeck(NeckParameters usual, std::uint32_t seed);

/// A muscle or an organ in one person: a little elsewhere, larger or smaller, and not the same along the neck. A sheet
/// keeps the depth of its superficial face.
Column varied(Column usual, std::uint32_t seed);
Sheet varied(Sheet usual, std::uint32_t seed);

/// Deviation of a vessel from its usual course at a level, {lateral, posterior} mm: no vessel is straight.
std::array<double, 2> tortuosity_mm(std::uint32_t seed, double z_mm, double amplitude_mm);

}  // namespace insonate::phantom
