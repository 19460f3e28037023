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

/// Echo of a perfect plane reflector perpendicular to the beam; 0 dB is the speckle of a 0 dB tissue.
inline constexpr double kReflectorGain_dB = 50;
/// Distance over which structures blend into each other: the resolution of CT and labels.
inline constexpr double kInterface_mm = 0.8;
/// Loss per mm outside the volume, so high that no echo is received from there.
inline constexpr double kBeyondLoss_dBpmm = 1000;
inline constexpr double kSpeckleContrast = 0.55;  ///< contrast of the speckle: SD of its amplitude divided by the mean
/// Size of the cells of the speckle noise, in units of the point-spread function's FWHM.
inline constexpr double kNoiseCellAxial = 2.2, kNoiseCellLateral = 2.4;
/// Length of the exponential tail of the radial blur (along the scanline), in units of the pulse's FWHM.
inline constexpr double kTail = 0.8;

/// Parameters of the thesis's rendering style that depend only on probe and settings.
struct ThesisPlan {
  explicit ThesisPlan(const FramePlan& plan);

  int mapRows;  ///< number of map rows, at half the distance of node rows, since interfaces vary faster than distances
  double row_mm;         ///< distance between node rows
  double interface_mm;   ///< kInterface_mm, or more if the map rows are too far apart to sample it
  double steepness_mm;   ///< factor from a slope (per mm) to the step across an interface: interface_mm over
                         ///< the maximum of fade()'s slope
  double lossLength_mm;  ///< length over which a plane interface's loss is spread, so that its integral is correct
  double tailShare;      ///< share of an echo that the radial blur passes on to the next gate
  NoiseCells noise;

  double mapRow_mm() const { return row_mm / 2; }
};

/// Acoustic constants of one channel of the tissue field; effects that are switched off are left out.
struct ChannelAcoustics {
  double lnImpedance = 0, lnImpedancePerHU = 0;
  double loss_dBpmm = 0;  ///< two-way attenuation, twice alpha f^n
  double echo_dB = 0, echo_dBperHU = 0;
};
std::array<ChannelAcoustics, TissueField::kStride> channelAcoustics(const ImagingSettings& settings,
                                                                    const AcousticScene::Impl& scene);

/// Signed distances and CT deviation at a node.
struct SceneSample {
  std::array<double, TissueField::kStride> distance_mm{};
  double ctDeviation_HU = 0;
  double beyond = 0;  ///< 0: inside the volume; 1: outside
};
SceneSample sampleScene(const TissueField& field, Vec3 patient_mm);
/// Returns how far a node index lies outside the volume: 0 up to half a node beyond the lattice, rising to 1 over the
/// next half node.
double beyondLattice(const TissueField& field, Vec3 node);

/// Medium and boundary at a node, as amplitudes.
struct MapSample {
  double reflection = 0;  ///< echo of the boundary, including the reflector's gain
  double loss_dBpmm = 0;  ///< two-way loss by absorption and reflection
  double echo = 0;        ///< amplitude of the scattering
};

/// Returns the amplitude reflected by a boundary, equation 6 of the thesis as an amplitude: |d . gradZ| / (2Z) is half
/// the slope of ln Z along the beam. Over an interface, half the change of ln Z is artanh R, so that tanh is correct
/// for strong contrasts, too. The slope along the beam includes the cosine of incidence.
double reflectionOf(double lnImpedanceSlope_pmm, const ThesisPlan& plan);
/// Returns the two-way loss by reflection, corresponding to the factor (1 - reflected) of equation 8 of the thesis.
double reflectionLoss_dBpmm(double lnImpedanceSlope_pmm, const ThesisPlan& plan);

/// Computes medium and boundary at a node from the scene at the node (`here`) and its change along the beam per mm
/// (`slope`).
MapSample mapAt(const SceneSample& here, const SceneSample& slope, double range_mm, const ThesisPlan& plan,
                const ImagingSettings& settings, const AcousticScene::Impl& scene,
                const std::array<ChannelAcoustics, TissueField::kStride>& channels);

/// Tells whether background (label 0) at this range may be gel or air between the probe's face and the skin, which does
/// not echo. Beyond a limit, background is imaged like tissue.
inline bool mayBeGel(double range_mm) {
  return range_mm < acoustics::kContactReach_mm;
}

/// Returns the factor of speckle on the scattering amplitude for a value of the noise; its mean power is 1.
double speckleFactor(double noise);

}  // namespace insonate::thesis
