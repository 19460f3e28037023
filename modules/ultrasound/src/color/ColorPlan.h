#pragma once

#include "model/Contact.h"
#include "scene/SceneData.h"

#include <insonate/ultrasound/BeamGrid.h>
#include <insonate/ultrasound/ColorSettings.h>

#include <algorithm>
#include <array>
#include <complex>
#include <vector>

namespace insonate {

/// All data of color Doppler that depend only on probe and settings.
///
/// Echoes are computed at the points of a lattice, kFine points for each scanline and each gate, in three elevation
/// planes, and are then averaged over the sample volume of each gate.
struct ColorPlan {
  static constexpr int kFine = 2;
  static constexpr int kPlanes = 3;
  static constexpr double kTransmissionStep_mm = 0.5;
  /// Slope of the wall filter: the power falls with this power of the frequency.
  static constexpr double kWallFilterPower = 8;

  ColorPlan(const Probe& probe, const ImagingSettings& settings, const ColorSettings& color);

  ColorSettings color;
  ImagingSettings imaging;
  BeamGrid image;  ///< scanlines of the B-mode image
  BeamGrid beams;  ///< scanlines of color over the whole width of the field of view; samples are not used
  int firstBeam = 0, lines = 0, gates = 0;
  double gate_mm = 0;  ///< distance between gates

  /// Half-widths of the lattice beyond the box, in its points.
  int lateralMargin = 0, axialMargin = 0;
  int fineLines = 0, fineGates = 0;
  std::vector<double> axialKernel;  ///< weights by distance from the gate, center first; unit sum over both sides
  /// Weights of lattice lines by distance, [gate][lateralMargin + 1]; unit sum over both sides.
  std::vector<double> lateralKernel;
  std::array<double, kPlanes> elevation_mm{}, planeWeight{};

  double nyquist_mmps = 0;
  double noisePower = 1;  ///< power of the noise relative to speckle of 0 dB
  int transmissionSteps = 0;

  /// Return scanline and range of a lattice point.
  double beam(int fineLine) const { return firstBeam + double(fineLine - lateralMargin) / kFine; }
  double range_mm(int fineGate) const {
    return color.near_mm + (0.5 + double(fineGate - axialMargin) / kFine) * gate_mm;
  }
  /// Returns the range of a point of the lattice of transmission.
  static double transmissionRange_mm(int step) { return (step + 0.5) * kTransmissionStep_mm; }
  Vec3 point_mm(double beam, double range_mm) const { return beams.origin(beam) + beams.direction(beam) * range_mm; }
  double gateRange_mm(int gate) const { return color.near_mm + (gate + 0.5) * gate_mm; }

  /// Returns the share of the power that passes the wall filter, for a velocity toward the probe.
  double wallFilter(double toward_mmps) const;
  /// Returns the change of phase between two pulses.
  double phase(double toward_mmps) const;

 private:
  void planKernels(const Probe& probe);
};

/// Positions at rest of the tissue that the B-mode image shows: drawn to the face by the contact rule, then displaced.
class ShownTissue {
 public:
  static constexpr int kColumns = 33;  ///< columns of the image at which the contact is computed
  static constexpr int kKnotStep = 4;  ///< points of a scanline from one computed position to the next
  explicit ShownTissue(const ColorPlan& plan);
  void update(const ColorPlan& plan, const TissueField& field, const Transform& patientFromProbe,
              const PlaneDisplacement& displacement);
  /// Returns the position at rest, probe frame, of the tissue at a displayed point of the image plane.
  Vec3 restOf(Vec3 shown_mm) const;
  /// Calls put(i, rest) with the position at rest of each of `count` points of a scanline, at range_mm(i). Positions
  /// are computed for each kKnotStep-th point and interpolated, since the displacement changes little over these
  /// distances.
  template <class Range, class Put>
  void restAlong(double beam, int count, const Range& range_mm, const Put& put) const {
    const auto rest = [&](int i) { return restOf(plan_->point_mm(beam, std::max(range_mm(i), 0.0))); };
    Vec3 from = rest(0);
    for (int first = 0; first < count; first += kKnotStep) {
      const Vec3 to = rest(first + kKnotStep);
      for (int i = first; i < std::min(first + kKnotStep, count); ++i)
        put(i, from + (to - from) * (double(i - first) / kKnotStep));
      from = to;
    }
  }
  /// Returns the strength of the contact above a displayed point.
  double contactAbove(Vec3 shown_mm) const;
  /// Returns the position of a scanline of the image among the columns.
  static double columnOf(const ColorPlan& plan, double scanline) {
    return std::clamp(scanline / (plan.image.scanlines() - 1) * (kColumns - 1), 0.0, double(kColumns - 1));
  }
  /// Returns the scanline of the image in a column.
  static double scanlineOf(const ColorPlan& plan, int column) {
    return double(column) / (kColumns - 1) * (plan.image.scanlines() - 1);
  }

 private:
  Contact contactAt(Vec3 shown_mm, double& range_mm, double& scanline) const;

  bool isDrawn_ = false;  ///< the contact rule moves tissue anywhere

  const ColorPlan* plan_;
  const PlaneDisplacement* displacement_ = nullptr;
  std::array<Contact, kColumns> contacts_{};
};

/// Width of the gradual change from tissue to blood at the wall of a lumen. A point of the lattice stands for the
/// tissue around it; without a gradual change, the outline of color would follow the lattice.
inline constexpr double kBloodEdge_mm = 0.25;
/// Share of blood at a point of the lattice, by the distance to the wall of the lumen (negative inside).
inline double bloodShare(double toWall_mm) {
  return std::clamp(0.5 - toWall_mm / kBloodEdge_mm, 0.0, 1.0);
}
/// Smallest depth at which the velocity of blood is looked up, for points whose middle lies outside the lumen.
inline constexpr double kLeastDepth_mm = 0.01;

/// Loss of power of the echoes between two points of a scanline, by the labels of the tissue there: two-way absorption
/// over `step_mm` in the second tissue, and the loss at a boundary between different impedances.
double transmittedPower(const AcousticTable& table, const ColorPlan& plan, std::uint8_t before, std::uint8_t here,
                        double step_mm);

}  // namespace insonate
