#pragma once

#include <insonate/tissue/AcousticTable.h>

#include <cmath>

namespace insonate {

/// Amplitude of a boundary's echo as a function of the cosine of incidence: cos^n, plus a diffuse share proportional to
/// cos. With n = 1 and no diffuse share this is equation 6 of the thesis (an intensity, cos^2).
template <class Real>
Real specularLobe(const AcousticTissue& above, const AcousticTissue& below, Real cosine) {
  const auto n = static_cast<Real>((above.specularExponent + below.specularExponent) / 2);
  const auto diffuse = static_cast<Real>((above.specularDiffuse + below.specularDiffuse) / 2);
  return (1 - diffuse) * std::pow(cosine, n) + diffuse * cosine;
}

/// Constants of rough boundaries, per dB of roughness. kRoughnessLoss: mean loss of the in-phase echo, compared with a
/// mirror. kRoughnessBreaks: weight of dark places, since the echo breaks off more than it brightens.
/// kRoughnessDepth_mmPdB: depth over which the echo is spread.
inline constexpr double kRoughnessLoss = 0.8, kRoughnessBreaks = 2.5, kRoughnessDepth_mmPdB = 0.05;

/// Gain of a boundary's echo. `patch` is the local value of a random field of SD 1 that varies the echo along the
/// boundary.
inline double roughnessGain_dB(const AcousticTissue& below, double patch) {
  return below.roughness_dB * ((patch < 0 ? kRoughnessBreaks * patch : patch) - kRoughnessLoss);
}

/// Depth over which a rough boundary's echo is spread, mm.
inline double roughnessDepth_mm(const AcousticTissue& below) {
  return kRoughnessDepth_mmPdB * below.roughness_dB;
}

/// Share of the echo of a sheet or layer that is in phase. Collagen is rough at the scale of a wavelength: most of its
/// echo has a random phase and appears as speckle along the sheet.
inline constexpr double kSheetCoherence = 0.35;

/// SD of the displacement of a boundary's layers, so that they are not exactly parallel to the boundary. The
/// displacement is read from the field that makes the layers come and go, kWanderStep_voxels away.
inline constexpr double kLayerWander_mm = 0.15;
inline constexpr int kWanderStep_voxels = 23;

/// Share of a sheet's echo that is received if the beam meets the sheet with this cosine of incidence.
inline double sheetFacing(double cosine) {
  return 0.2 + 0.8 * cosine * cosine;
}

/// Tells whether a texture's bright parts are sheets, which echo coherently, rather than denser scatterers.
inline bool hasSheets(Texture texture) {
  return texture == Texture::Septa || texture == Texture::Lobules || texture == Texture::Sheets ||
         texture == Texture::Bundles;
}

}  // namespace insonate
