#pragma once

#include "model/ApertureRays.h"
#include "model/BeamField.h"

#include <insonate/ultrasound/BeamGrid.h>

#include <cstdint>
#include <vector>

namespace insonate {

/// Constants of the acoustic model, except those of tissues and probes.
namespace acoustics {
inline constexpr double kFwhmPerSd = 2.3548200450309493;
/// Envelope of the echo of a perfect plane reflector (R = 1) perpendicular to the beam; 0 dB is the speckle of a 0 dB
/// tissue.
inline constexpr double kReflectorGain_dB = 58;
/// Depth over which the movement of tissue falls to 1/e, below skin that is drawn to the face.
inline constexpr double kContactDepth_mm = 15;
/// Maximum distance between face and skin at which the probe receives echoes.
inline constexpr double kContactReach_mm = 12;
inline constexpr double kPoorContact_mm = 6;  ///< gap between face and skin beyond which contact is lost gradually
/// Edge shadow: loss by refraction at the sides of vessels, where the beam grazes the wall.
inline constexpr double kEdgeLoss_dBpcmMHz = 1.1;
inline constexpr double kEdgeCosine = 0.35;
inline constexpr double kEdgeReach_mm = 0.35;
/// Echoes behind gas are the tissue above, mirrored, and echoes that go back and forth between probe and gas (rings).
/// kMirrorShare: level of the mirrored tissue; the other constants give its decay, and period, decay and level of the
/// rings.
inline constexpr double kMirrorShare = 0.07;
inline constexpr double kMirrorDecay_mm = 4;
inline constexpr double kRingPeriod_mm = 1.55;
inline constexpr double kRingDecay_mm = 2;
inline constexpr double kRingShare = 0.1;
inline constexpr int kMaxLooks = 3;
}  // namespace acoustics

/// All data of a frame that depend only on probe and settings, computed once.
///
/// Echoes are computed at "gates": every `stride`-th sample of a scanline, close enough for the pulse (at least 2.4
/// gates within its FWHM). Structures are looked up on a coarser lattice of nodes and interpolated within cells of
/// cellGates x cellLines gates.
struct FramePlan {
  FramePlan(const Probe& probe, const ImagingSettings& settings);

  Probe probe;
  ImagingSettings settings;
  BeamGrid grid;
  BeamField field;
  int lines = 0;
  int stride = 1;      ///< number of samples per gate
  int gates = 0;       ///< number of gates per scanline
  double gate_mm = 0;  ///< distance between gates
  ApertureRays aperture;
  int cellGates = 1, cellLines = 1;
  int nodeRows = 0, nodeColumns = 0;

  /// Offset of each elevation plane from the central plane, in SDs of the slice (BeamField::sliceSd_mm), and the
  /// weights of each plane. Each plane represents the part of the slice that is nearest to the plane. For scattering,
  /// the weight is the root of this part's power (unit total power); for boundaries, the weight is this part's
  /// amplitude (unit sum).
  std::vector<double> planeOffset_sd, scatterWeight, boundaryWeight;
  std::vector<double> elevationSd_mm;  ///< SD of the slice at each gate (BeamField::sliceSd_mm)
  /// Distance between neighboring elevation planes in SDs of the slice; 0 for a single plane, which has no thickness.
  double planeSpacing_sd = 0;

  /// Number that makes the speckle of different steering angles independent; 0 for the straight angle. From 5 degrees
  /// on, the carrier's phase turns by more than a radian over the width of the beam (4 pi sin(angle) / wavelength per
  /// mm), so that also in reality speckle differs between angles.
  std::uint32_t specklePattern = 0;
  double latticePitch_mm = 0;           ///< distance between scatterers perpendicular to the elevation direction
  double latticeElevationPitch_mm = 0;  ///< distance between scatterers along the elevation direction
  /// Factor on scattering at each gate, by which the envelope of a 0 dB tissue has RMS 1 after the point-spread
  /// function.
  std::vector<double> scatterScale;
  /// Factor on boundary echoes, by which the peak of a plane reflector equals its reflection coefficient.
  double boundaryScale = 1;

  /// Point-spread function: half of each gate's kernels, center first; the radius is the number of further entries. The
  /// lateral kernels and the axial kernel at the face have unit sum. The axial kernels of all gates give a reflector
  /// the same peak.
  std::vector<int> axialRadius;  ///< radius of the axial kernel at each gate
  int maxAxialRadius = 0;
  std::vector<double> axialKernel;  ///< half of each gate's axial kernel, [gate][maxAxialRadius + 1]
  std::vector<int> lateralRadius;   ///< radius of the lateral kernel at each gate
  int maxLateralRadius = 0;
  std::vector<double> lateralKernel;  ///< half of each gate's lateral kernel, [gate][maxLateralRadius + 1]

  double range_mm(double gate) const { return (gate + 0.5) * gate_mm; }

 private:
  void planeElevation();
  void planeBeam();
  std::vector<std::vector<double>> axialHalves() const;
  double impulsePeak(const std::vector<double>& half) const;
  /// Returns the variance of scattering of unit variance at a gate after the point-spread function, computed from the
  /// autocorrelations of the gate's kernels.
  double speckleVariance(int gate, const std::vector<double>& axialLags, const std::vector<double>& lateralLags) const;
};

/// Weights of the gates k - 1 .. k + 2 for cubic (Catmull-Rom) interpolation at a fraction after gate k. The gates are
/// much closer than the pulse's length, so that four gates determine the samples between them.
struct CubicWeights {
  double weight[4];
};
CubicWeights cubicAt(double fraction);

}  // namespace insonate
