#pragma once

#include "pointspread/Spread.h"

#include <insonate/ultrasound/BeamGrid.h>
#include <insonate/ultrasound/Frames.h>

#include <vector>

namespace insonate::bench {

/// Echo amplitudes in an anechoic cyst and beside it at the same depth.
struct CystEchoes {
  std::vector<double> inside, beside;

  /// Adds the amplitude at a point (x, z) relative to the middle of a cyst. Points within 0.7 of the cyst's radius
  /// count as inside; points 1.5 to 5 mm from the cyst's wall count as beside the cyst.
  void add(double x_mm, double z_mm, double diameter_mm, double amplitude);
};

/// Returns the mean amplitude divided by the standard deviation of the amplitudes: 1.91 for fully developed speckle.
double speckleSnr(const CystEchoes& echoes);
/// Returns the contrast-to-noise ratio: the difference of the mean amplitudes divided by the root of the sum of their
/// variances.
double contrastToNoise(const CystEchoes& echoes);
/// Returns the generalized contrast-to-noise ratio: the share of pixels that the best threshold classifies beyond
/// chance, 0 to 1 (Rodriguez-Molares et al., IEEE Trans UFFC 2020, 67:745).
double generalizedContrastToNoise(const CystEchoes& echoes);

/// Simulates speckle with a cyst in the middle, and returns its echoes: complex white noise without the cyst's disk is
/// convolved with the echo of a point (`spread`).
CystEchoes cystOf(const Spread& spread, double diameter_mm);

/// Adds the echoes around a cyst in a frame of an engine.
void addCyst(const EnvelopeFrame& frame, const BeamGrid& grid, Vec3 middle_mm, double diameter_mm, CystEchoes& echoes);

/// Sets the figures of two cysts, with diameters of 4 mm (`small`) and 8 mm (`large`).
void addCystFigures(const CystEchoes& small, const CystEchoes& large, PointSpreadFigures& figures);

}  // namespace insonate::bench
