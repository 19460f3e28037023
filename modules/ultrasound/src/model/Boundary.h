#pragma once

#include <insonate/tissue/AcousticTable.h>

#include <cmath>

namespace insonate {

/// Amplitude of a boundary's echo against the cosine of incidence: cos^n, plus a diffuse share that falls as cos. With
/// n = 1 and no diffuse share this is the thesis's equation 6 (an intensity, cos^2).
inline double specularLobe(const AcousticTissue& above, const AcousticTissue& below, double cosine) {
  const double n = (above.specularExponent + below.specularExponent) / 2;
  const double diffuse = (above.specularDiffuse + below.specularDiffuse) / 2;
  return (1 - diffuse) * std::pow(cosine, n) + diffuse * cosine;
}

}  // namespace insonate
