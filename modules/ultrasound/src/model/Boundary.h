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

/// A rough boundary returns less in phase than a mirror, over some depth, and breaks off more easily than it brightens:
/// its loss in the mean and the weight of dark places, both per dB of roughness, and the depth.
inline constexpr double kRoughnessLoss = 0.8, kRoughnessBreaks = 2.5, kRoughnessDepth_mmPdB = 0.05;

/// Gain of a boundary's echo; `patch` is the local value of a random field of SD 1 that varies the echo along it.
inline double roughnessGain_dB(const AcousticTissue& below, double patch) {
  return below.roughness_dB * ((patch < 0 ? kRoughnessBreaks * patch : patch) - kRoughnessLoss);
}

/// Depth over which a rough boundary's echo spreads, mm.
inline double roughnessDepth_mm(const AcousticTissue& below) {
  return kRoughnessDepth_mmPdB * below.roughness_dB;
}

/// Share of a sheet's or layer's echo that comes back in phase. Collagen is rough at the scale of a wavelength: most of
/// its echo has a random phase and shows as grains along the sheet.
inline constexpr double kSheetCoherence = 0.35;

/// SD of the place of a boundary's layers along the boundary, so that they do not run as rails; the field that moves
/// them is the one that makes them come and go, taken this far aside.
inline constexpr double kLayerWander_mm = 0.15;
inline constexpr int kWanderStep_voxels = 23;

/// Share of a sheet's echo that comes back where the beam meets it with this cosine.
inline double sheetFacing(double cosine) {
  return 0.2 + 0.8 * cosine * cosine;
}

/// Textures whose bright parts are sheets, which echo as one, rather than denser scatterers.
inline bool hasSheets(Texture texture) {
  return texture == Texture::Septa || texture == Texture::Lobules || texture == Texture::Sheets ||
         texture == Texture::Bundles;
}

}  // namespace insonate
