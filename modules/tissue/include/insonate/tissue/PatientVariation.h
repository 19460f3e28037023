#pragma once

#include <insonate/tissue/AcousticTable.h>

#include <cstdint>

namespace insonate {

/// Returns the table of one simulated patient: echogenicity, texture, roughness and connective layers vary from patient
/// to patient around the values of `table`. Muscle and fat vary most, since muscle becomes more echogenic with age and
/// fat content. The same seed gives the same patient. Impedance and attenuation keep their published values, so that
/// echo levels and shadows stay accurate. A texture, layer or roughness of 0 dB in `table` stays 0 dB.
///
/// Standard deviations: echogenicity 1.5 dB (muscle and fat 2.5 dB); texture strength 15 %; roughness 20 %; echo of
/// layers 2 dB; thickness of layers 20 %; patchiness of layers 0.12. No value deviates by more than two standard
/// deviations. These amounts were chosen, not measured. The increase of the echogenicity of muscle with age is from
/// Arts et al., Muscle Nerve 2010; 41:32.
AcousticTable tableOfPatient(const AcousticTable& table, std::uint32_t seed);

}  // namespace insonate
