#pragma once

#include "model/FramePlan.h"
#include "scene/SceneData.h"
#include "thesis/PerlinNoise.h"

#include <array>

/// The look of the thesis: four layers over the CT and its labels, sampled in the imaging plane.
///
/// On the frame plan's lattice of nodes, and midway between its rows, the labels give impedance, attenuation and
/// echogenicity, blended across boundaries, and the CT modulates them within each structure. Down each scanline
///   echo = amplitude * (echogenicity * speckle + gain * reflection),
/// where the amplitude is what absorption and reflection have left, there and back (equations 7 and 8). Elevation
/// planes are averaged, then the radial blur follows. All amplitudes; the thesis writes intensities, their squares.
namespace insonate::thesis {

/// Echo of a perfect plane reflector square to the beam, over unit speckle.
inline constexpr double kReflectorGain_dB = 50;
/// Structures blend into each other over this distance: what CT and labels resolve.
inline constexpr double kInterface_mm = 0.8;
/// Loss beyond the volume, where nothing is received.
inline constexpr double kBeyondLoss_dBpmm = 1000;
inline constexpr double kSpeckleContrast = 0.55;  ///< SD over mean of the speckle's amplitude
/// Cells of the noise, in units of the point-spread function's FWHM.
inline constexpr double kNoiseCellAxial = 2.2, kNoiseCellLateral = 2.4;
/// Exponential tail of the radial blur, in units of the pulse's FWHM.
inline constexpr double kTail = 0.8;

/// Parameters that depend on probe and settings alone.
struct ThesisPlan {
  explicit ThesisPlan(const FramePlan& plan);

  int mapRows;           ///< twice as close as the node rows: distances vary slowly, their interfaces do not
  double row_mm;         ///< between node rows
  double interface_mm;   ///< kInterface_mm, where the map rows are close enough to sample it
  double steepness_mm;   ///< interface_mm over the greatest slope of fade(): change per mm to change of an interface
  double lossLength_mm;  ///< over which a plane interface's loss is spread, so that its integral is right
  double tailShare;      ///< of the radial blur that passes from gate to gate
  NoiseCells noise;

  double mapRow_mm() const { return row_mm / 2; }
};

/// Acoustic constants of one channel of the tissue field, with the effects that are switched off left out.
struct ChannelAcoustics {
  double lnImpedance = 0, lnImpedancePerHU = 0;
  double loss_dBpmm = 0;  ///< there and back: twice alpha f^n
  double echo_dB = 0, echo_dBperHU = 0;
};
std::array<ChannelAcoustics, TissueField::kStride> channelAcoustics(const ImagingSettings& settings,
                                                                    const AcousticScene::Impl& scene);

/// The scene at a node.
struct SceneSample {
  std::array<double, TissueField::kStride> distance_mm{};
  double ctDeviation_HU = 0;
  double beyond = 0;  ///< 0 inside the volume .. 1 outside
};
SceneSample sampleScene(const TissueField& field, Vec3 patient_mm);
/// Nodes from half a voxel beyond the lattice on are outside.
double beyondLattice(const TissueField& field, Vec3 node);

/// Medium and boundary at a node, as amplitudes.
struct MapSample {
  double reflection = 0;  ///< gain included
  double loss_dBpmm = 0;  ///< absorption and reflection, there and back
  double echo = 0;        ///< of the scattering
};

/// Equation 6 as an amplitude: |d . gradZ| / (2Z) is half the slope of ln Z along the beam. Over an interface, half the
/// change of ln Z is artanh R, so that tanh keeps strong contrasts right too. The slope along the beam carries the
/// cosine of incidence.
double reflectionOf(double lnImpedanceSlope_pmm, const ThesisPlan& plan);
/// Two-way loss by the factor (1 - reflected) of equation 8 of the thesis.
double reflectionLoss_dBpmm(double lnImpedanceSlope_pmm, const ThesisPlan& plan);

/// Maps a node and its change along the beam, per mm.
MapSample mapAt(const SceneSample& here, const SceneSample& slope, double range_mm, const ThesisPlan& plan,
                const ImagingSettings& settings, const AcousticScene::Impl& scene,
                const std::array<ChannelAcoustics, TissueField::kStride>& channels);

/// Structures before the skin are gel or air in front of the face; deeper ones are seen.
inline bool mayBeGel(double range_mm) {
  return range_mm < acoustics::kContactReach_mm;
}

/// Factor on scattering, of unit power.
double speckleFactor(double noise);

}  // namespace insonate::thesis
