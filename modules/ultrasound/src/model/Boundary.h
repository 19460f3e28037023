#pragma once

#include <insonate/tissue/AcousticTable.h>

#include <cmath>

namespace insonate {

/// Amplitude of a boundary's echo against the cosine of incidence: cos^n, plus a diffuse share that falls as cos. With
/// n = 1 and no diffuse share this is the thesis's equation 6 (an intensity, cos^2).
template <class Real>
Real specularLobe(const AcousticTissue& above, const AcousticTissue& below, Real cosine) {
  const auto n = static_cast<Real>((above.specularExponent + below.specularExponent) / 2);
  const auto diffuse = static_cast<Real>((above.specularDiffuse + below.specularDiffuse) / 2);
  return (1 - diffuse) * std::pow(cosine, n) + diffuse * cosine;
}

/// What a boundary's echo gains where `patch`, of unit SD, is what comes and goes along it. An outline breaks off more
/// easily than it brightens.
inline double roughnessGain_dB(const AcousticTissue& below, double patch) {
  constexpr double kBreaks = 2.5;
  return below.roughness_dB * (patch < 0 ? kBreaks * patch : patch);
}

/// Share of a sheet's echo that comes back where the beam meets it with this cosine.
inline double sheetFacing(double cosine) {
  return 0.2 + 0.8 * cosine * cosine;
}

/// Textures whose bright parts are sheets, which echo as one, rather than denser scatterers.
inline bool hasSheets(Texture texture) {
  return texture == Texture::Septa || texture == Texture::Lobules || texture == Texture::Sheets;
}

}  // namespace insonate
