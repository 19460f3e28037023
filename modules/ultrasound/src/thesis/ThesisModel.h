#pragma once

#include "model/FramePlan.h"
#include "scene/SceneData.h"
#include "thesis/PerlinNoise.h"

#include <array>

/// Rendering style of the thesis: four layers computed from the CT and its labels, sampled in the imaging plane.
///
/// On the frame plan's lattice of nodes, and midway between its rows, the labels give impedance, attenuation and
/// echogenicity, blended across boundaries, and the CT modulates them within each structure. Down each scanline
///   echo = amplitude * (echogenicity * speckle + gain * reflection), where the amplitude is the two-way amplitude
/// after absorption and reflection (equations 7 and 8). Elevation planes are averaged, then the radial blur is applied.
/// All values are amplitudes; the thesis uses intensities, their squares.
namespace insonate::thesis {

/// Echo of a perfect plane reflector perpendicular to the beam, relative to unit speckle.
inline constexpr double kReflectorGain_dB = 50;
/// Distance over which structures blend into each other: the resolution of CT and labels.
inline constexpr double kInterface_mm = 0.8;
/// Loss outside the volume, from which nothing is received.
inline constexpr double kBeyondLoss_dBpmm = 1000;
inline constexpr double kSpeckleContrast = 0.55;  ///< SD over mean of the speckle's amplitude
/// Size of the noise's cells, in units of the point-spread function's FWHM.
inline constexpr double kNoiseCellAxial = 2.2, kNoiseCellLateral = 2.4;
/// Length of the radial blur's exponential tail, in units of the pulse's FWHM.
inline constexpr double kTail = 0.8;

/// Parameters that depend on probe and settings alone.
struct ThesisPlan {
  explicit ThesisPlan(const FramePlan& plan);

  int mapRows;  ///< number of map rows, at half the distance of node rows: distances vary slowly, but interfaces do not
  double row_mm;         ///< distance between node rows
  double interface_mm;   ///< kInterface_mm, or more if the map rows are too far apart to sample it
  double steepness_mm;   ///< interface_mm over the maximum slope of fade(); multiplied by a change per mm, it gives the
                         ///< change over an interface
  double lossLength_mm;  ///< length over which a plane interface's loss is spread, so that its integral is correct
  double tailShare;      ///< share of the radial blur that passes to the next gate
  NoiseCells noise;

  double mapRow_mm() const { return row_mm / 2; }
};

/// Acoustic constants of one channel of the tissue field, without the effects that are switched off.
struct ChannelAcoustics {
  double lnImpedance = 0, lnImpedancePerHU = 0;
  double loss_dBpmm = 0;  ///< two-way: twice alpha f^n
  double echo_dB = 0, echo_dBperHU = 0;
};
std::array<ChannelAcoustics, TissueField::kStride> channelAcoustics(const ImagingSettings& settings,
                                                                    const AcousticScene::Impl& scene);

/// The scene at a node.
struct SceneSample {
  std::array<double, TissueField::kStride> distance_mm{};
  double ctDeviation_HU = 0;
  double beyond = 0;  ///< 0: inside the volume .. 1: outside
};
SceneSample sampleScene(const TissueField& field, Vec3 patient_mm);
/// Returns 0 up to half a node beyond the lattice, and rises to 1 over the next half node.
double beyondLattice(const TissueField& field, Vec3 node);

/// Medium and boundary at a node, as amplitudes.
struct MapSample {
  double reflection = 0;  ///< includes the gain
  double loss_dBpmm = 0;  ///< two-way, by absorption and reflection
  double echo = 0;        ///< amplitude of the scattering
};

/// Equation 6 as an amplitude: |d . gradZ| / (2Z) is half the slope of ln Z along the beam. Over an interface, half the
/// change of ln Z is artanh R, so that tanh is correct for strong contrasts, too. The slope along the beam includes the
/// cosine of incidence.
double reflectionOf(double lnImpedanceSlope_pmm, const ThesisPlan& plan);
/// Two-way loss corresponding to the factor (1 - reflected) of equation 8 of the thesis.
double reflectionLoss_dBpmm(double lnImpedanceSlope_pmm, const ThesisPlan& plan);

/// Computes medium and boundary from the scene at a node and its change along the beam, per mm.
MapSample mapAt(const SceneSample& here, const SceneSample& slope, double range_mm, const ThesisPlan& plan,
                const ImagingSettings& settings, const AcousticScene::Impl& scene,
                const std::array<ChannelAcoustics, TissueField::kStride>& channels);

/// Tells whether a structure at this range, in front of the skin, may be gel or air in front of the face; at larger
/// ranges it is visible.
inline bool mayBeGel(double range_mm) {
  return range_mm < acoustics::kContactReach_mm;
}

/// Factor on scattering, with unit power.
double speckleFactor(double noise);

}  // namespace insonate::thesis
