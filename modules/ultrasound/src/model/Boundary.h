#pragma once

#include <insonate/tissue/AcousticTable.h>

#include <algorithm>
#include <cmath>

namespace insonate {

/// Returns the relative amplitude of a boundary's echo for a cosine of incidence: cos^n, plus a diffuse share
/// proportional to cos. With n = 1 and no diffuse share this is equation 6 of the thesis (an intensity, cos^2).
template <class Real>
Real specularLobe(const AcousticTissue& above, const AcousticTissue& below, Real cosine) {
  const auto n = static_cast<Real>((above.specularExponent + below.specularExponent) / 2);
  const auto diffuse = static_cast<Real>((above.specularDiffuse + below.specularDiffuse) / 2);
  return (1 - diffuse) * std::pow(cosine, n) + diffuse * cosine;
}

/// Constants of rough boundaries, per dB of AcousticTissue::roughness_dB. kRoughnessLoss: mean loss of the in-phase
/// echo, compared with a smooth mirror. kRoughnessBreaks: factor on negative values of the random pattern, since dark
/// gaps are deeper than bright places are bright. kRoughnessDepth_mmPdB: depth over which the echo is spread.
inline constexpr double kRoughnessLoss = 0.5, kRoughnessBreaks = 2.5, kRoughnessDepth_mmPdB = 0.025;

/// Returns the tissue whose roughness a boundary has: that of the tissue below, but the intima of a vessel is as smooth
/// at its far wall as at its near wall.
inline const AcousticTissue& surfaceOf(const AcousticTissue& above, const AcousticTissue& below) {
  return above.vessel ? above : below;
}

/// Returns the gain in dB of a boundary's echo by roughness. `patch` is the local value of a random field of SD 1 that
/// varies the echo along the boundary.
inline double roughnessGain_dB(const AcousticTissue& surface, double patch) {
  return surface.roughness_dB * ((patch < 0 ? kRoughnessBreaks * patch : patch) - kRoughnessLoss);
}

/// Returns the depth over which the echo of a rough boundary is spread, mm.
inline double roughnessDepth_mm(const AcousticTissue& surface) {
  return kRoughnessDepth_mmPdB * surface.roughness_dB;
}

/// Presence of a layer at a point with the mean value of `patch`, and the slope of the presence.
inline constexpr double kLayerPresence = 0.5, kLayerPresencePerPatch = 0.9;

/// Returns the share of the tissue at a point that connective layers cover. `occupancy` is the occupancy of the layers'
/// profile at the point, `patchiness` the patchiness of the layers. `patch` is the local value of a random field of SD
/// 1. Where `patch` is low, a patchy layer is thinner as well as darker, since the profile's flanks fall below zero
/// first. The layer is interrupted where nothing of the profile is left.
inline double layerCover(double occupancy, double patchiness, double patch) {
  const double presence = std::clamp(kLayerPresence + kLayerPresencePerPatch * patch, 0.0, 1.0);
  return std::max(0.0, occupancy - patchiness * (1 - presence));
}

/// Share of the echo of a sheet or layer of connective tissue that is in phase. Collagen is rough at the scale of a
/// wavelength: most of its echo has a random phase and appears as speckle along the sheet.
inline constexpr double kSheetCoherence = 0.35;

/// Random displacement of a boundary's connective layers, so that they are not exactly parallel to the boundary:
/// kLayerWander_mm is its SD. The displacement is read from the random field that also varies the layers' strength,
/// kWanderStep_voxels away.
inline constexpr double kLayerWander_mm = 0.15;
inline constexpr int kWanderStep_voxels = 23;

/// Returns the share of a sheet's echo that is received if the beam meets the sheet with this cosine of incidence.
inline double sheetFacing(double cosine) {
  return 0.2 + 0.8 * cosine * cosine;
}

/// Tells whether a texture's bright parts are sheets, which echo coherently, rather than denser scatterers.
inline bool hasSheets(Texture texture) {
  return texture == Texture::Septa || texture == Texture::Lobules || texture == Texture::Sheets ||
         texture == Texture::Bundles;
}

}  // namespace insonate
