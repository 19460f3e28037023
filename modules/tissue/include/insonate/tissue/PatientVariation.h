#pragma once

#include <insonate/tissue/AcousticTable.h>

#include <cstdint>

namespace insonate {

/// Returns the table of one simulated patient: echogenicity, texture, roughness and connective layers vary from patient
/// to patient around the values of `table`. Muscle and fat vary most, since muscle becomes more echogenic with age and
/// fat content. The same seed gives the same patient. Impedance and attenuation keep their published values, so that
/// levels and shadows stay accurate. A texture, layer or roughness that is absent in `table` (0 dB) stays absent.
///
/// Standard deviations of the variation, which is limited to two standard deviations: echogenicity 1.5 dB, of muscle
/// and fat 2.5 dB; texture strength 15 %; roughness 20 %; layers 2 dB, 20 % of their thickness and 0.12 of patchiness.
/// These amounts were chosen, not measured; the increase of muscle with age is from Arts et al., Muscle Nerve 2010;
/// 41:32.
AcousticTable tableOfPatient(const AcousticTable& table, std::uint32_t seed);

}  // namespace insonate
