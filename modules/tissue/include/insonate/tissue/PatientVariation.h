#pragma once

#include <insonate/tissue/AcousticTable.h>

#include <cstdint>

namespace insonate {

/// The table of one patient: scattering, texture, roughness and connective layers differ from person to person, about
/// the values of the table. Muscle and fat differ most, since muscle echoes more with age and fat. The same seed gives
/// the same patient. Impedance and attenuation stay as published, so that levels and shadows keep their accuracy; what
/// the table leaves out (no texture, no layers, 0 dB of roughness) stays out.
///
/// Spread (standard deviation, cut at two of them): echogenicity 1.5 dB, of muscle and fat 2.5 dB; texture 15 % and
/// roughness 20 % of their strength; layers 2 dB, 20 % of their thickness and 0.12 of patchiness. The
/// amounts are chosen; that muscle echoes more with age: Arts et al., Muscle Nerve 2010; 41:32.
AcousticTable tableOfPatient(const AcousticTable& table, std::uint32_t seed);

}  // namespace insonate
