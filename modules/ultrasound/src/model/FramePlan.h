#pragma once

#include "model/ApertureRays.h"
#include "model/BeamField.h"

#include <insonate/ultrasound/BeamGrid.h>

#include <cstdint>
#include <vector>

namespace insonate {

/// Constants of the acoustic model that are not a tissue's or a probe's.
namespace acoustics {
inline constexpr double kFwhmPerSd = 2.3548200450309493;
/// Envelope of a perfect plane reflector (R = 1) perpendicular to the beam, over unit speckle.
inline constexpr double kReflectorGain_dB = 58;
/// Tissue is drawn to the face over this depth, as far as the skin follows it.
inline constexpr double kContactDepth_mm = 15;
inline constexpr double kContactReach_mm = 12;  ///< farther from the skin the probe hears nothing
inline constexpr double kPoorContact_mm = 6;    ///< gaps beyond this lose contact gradually
/// Refraction at the sides of vessels takes sound out of the beam where it grazes them.
inline constexpr double kEdgeLoss_dBpcmMHz = 1.1;
inline constexpr double kEdgeCosine = 0.35;
inline constexpr double kEdgeReach_mm = 0.35;
/// Behind gas: the tissue above, mirrored, and echoes between probe and gas.
inline constexpr double kMirrorShare = 0.07;
inline constexpr double kMirrorDecay_mm = 4;
inline constexpr double kRingPeriod_mm = 1.55;
inline constexpr double kRingDecay_mm = 2;
inline constexpr double kRingShare = 0.1;
inline constexpr int kMaxLooks = 3;
}  // namespace acoustics

/// Everything about a frame that follows from probe and settings alone, computed once.
///
/// Echoes are summed on "gates": every `stride`-th sample of a scanline, close enough for the pulse (2.4 of them or
/// more within its FWHM). Structures are looked up on a coarser lattice of nodes and interpolated within cells of
/// cellGates x cellLines gates.
struct FramePlan {
  FramePlan(const Probe& probe, const ImagingSettings& settings);

  Probe probe;
  ImagingSettings settings;
  BeamGrid grid;
  BeamField field;
  int lines = 0;
  int stride = 1;      ///< samples per gate
  int gates = 0;       ///< per scanline
  double gate_mm = 0;  ///< distance of gates
  ApertureRays aperture;
  int cellGates = 1, cellLines = 1;
  int nodeRows = 0, nodeColumns = 0;

  /// Elevation planes in units of the slice's SD (BeamField::sliceSd_mm). Each stands for the part of the slice that is
  /// nearest to it: weights of scattering are the root of its power (of unit power), of boundaries its amplitude (of
  /// unit sum).
  std::vector<double> planeOffset_sd, scatterWeight, boundaryWeight;
  std::vector<double> elevationSd_mm;  ///< [gate]
  /// Distance of neighboring planes in units of the SD; a single plane has no thickness: 0.
  double planeSpacing_sd = 0;

  /// Distinguishes the speckle of steering angles: over the width of the beam, the carrier's phase turns by more than
  /// a radian from 5 degrees on (4 pi sin(angle) / wavelength per mm), so that angles share little of it. 0: straight.
  std::uint32_t specklePattern = 0;
  double latticePitch_mm = 0;           ///< of the scatterers, across the elevation direction
  double latticeElevationPitch_mm = 0;  ///< along it
  std::vector<double> scatterScale;     ///< [gate] so that the envelope of a 0 dB tissue has RMS 1 after the beam
  double boundaryScale = 1;             ///< so that a plane reflector peaks at its reflection

  /// Point-spread function: half of each kernel (center first). Lateral kernels and the axial one at the face have unit
  /// sum; a reflector peaks alike after the axial kernels of all gates.
  std::vector<int> axialRadius;  ///< [gate]
  int maxAxialRadius = 0;
  std::vector<double> axialKernel;  ///< [gate][maxAxialRadius + 1]
  std::vector<int> lateralRadius;   ///< [gate]
  int maxLateralRadius = 0;
  std::vector<double> lateralKernel;  ///< [gate][maxLateralRadius + 1]

  double range_mm(double gate) const { return (gate + 0.5) * gate_mm; }

 private:
  void planeElevation();
  void planeBeam();
  std::vector<std::vector<double>> axialHalves() const;
  double impulsePeak(const std::vector<double>& half) const;
  /// Variance of unit scattering after the beam, at a gate; from the autocorrelations of its kernels.
  double speckleVariance(int gate, const std::vector<double>& axialLags, const std::vector<double>& lateralLags) const;
};

/// Catmull-Rom weights of gates k - 1 .. k + 2 at a fraction after gate k: the gates are far closer than the pulse is
/// long, so that the samples between them follow from four.
struct CubicWeights {
  double weight[4];
};
CubicWeights cubicAt(double fraction);

}  // namespace insonate
