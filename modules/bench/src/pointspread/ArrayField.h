#pragma once

#include <insonate/core/Vec3.h>
#include <insonate/ultrasound/ImagingSettings.h>

#include <complex>
#include <vector>

namespace insonate::bench {

/// Echo of a point from a linear array in homogeneous tissue without loss, summed over elements, over pieces of their
/// height, and over frequencies. The computation is slow, and independent of the engines. The equations are those of
/// Garcia, Comput Methods Programs Biomed 2022; 218:106726 (PFIELD and SIMUS): each piece is a source whose pressure at
/// a point is
///   exp(i k (r - delay)) / r * sinc(k b sin(theta)) * cos(theta), with k the wave number, b half an element's width
/// and theta the angle from the element's normal. The spectrum of a point's echo is the spectrum of the pulse times the
/// transmitted pressure times the received pressure.
///
/// The scanline lies at x = 0 of the array's frame (x along the array, y across the slice, z into the body).
/// Transmission focuses at focus_mm with an aperture of focus over transmitFNumber, half of it tapered. Reception
/// focuses at the point's depth with an aperture of depth over receiveFNumber, weighted by the probe's apodization. The
/// lens focuses both at elevationFocus_mm.
class ArrayField {
 public:
  /// Makes the field of a linear probe. `end_mm`: distance from the scanline to the nearer end of the array, beyond
  /// which there are no elements.
  ArrayField(const Probe& probe, const ImagingSettings& settings, double end_mm);

  /// Returns the complex envelope of a point's echo at depths from focus_mm - kReach_mm to focus_mm + kReach_mm in
  /// steps of kStep_mm; reception is focused at `focus_mm`.
  std::vector<std::complex<double>> echo(Vec3 point_mm, double focus_mm) const;
  static constexpr double kStep_mm = 0.01, kReach_mm = 1.5;

 private:
  struct Aperture {
    std::vector<double> x_mm, weight, delay_mm;
  };
  Aperture apertureOf(double width_mm, double focus_mm, Apodization apodization) const;
  std::vector<std::complex<double>> pressure(const Aperture& aperture, Vec3 point_mm) const;

  Probe probe_;
  double frequency_MHz_, transmitFocus_mm_, end_mm_;
  /// wave number, and spectrum of the pulse; one value for each frequency
  std::vector<double> waveNumber_radPmm_, spectrum_;
  /// For each piece of an element's height: its position, and the delay of the lens as a path length.
  std::vector<double> height_mm_, lens_mm_;
};

}  // namespace insonate::bench
