#pragma once

#include "pointspread/Spread.h"

#include <insonate/ultrasound/BeamGrid.h>
#include <insonate/ultrasound/Frames.h>

#include <vector>

namespace insonate::bench {

/// Echo amplitudes in an anechoic cyst and beside it at the same depth.
struct CystEchoes {
  std::vector<double> inside, beside;

  /// Takes the amplitudes of an image: of a place at (x, z) relative to the middle of a cyst, inside up to 0.7 of its
  /// radius, beside it 1.5 to 5 mm from its wall.
  void add(double x_mm, double z_mm, double diameter_mm, double amplitude);
};

/// Mean amplitude over its standard deviation: 1.91 for fully developed speckle.
double speckleSnr(const CystEchoes& echoes);
/// Contrast-to-noise ratio: difference of the mean amplitudes over the root of the sum of their variances.
double contrastToNoise(const CystEchoes& echoes);
/// Generalized contrast-to-noise ratio: the share of pixels that the best threshold classifies beyond chance, 0 to 1
/// (Rodriguez-Molares et al., IEEE Trans UFFC 2020, 67:745).
double generalizedContrastToNoise(const CystEchoes& echoes);

/// Echoes of speckle with this point spread and a cyst in the middle: complex white noise without the cyst's disk,
/// convolved with the point's echo.
CystEchoes cystOf(const Spread& spread, double diameter_mm);

/// Echoes around a cyst in a frame of an engine.
void addCyst(const EnvelopeFrame& frame, const BeamGrid& grid, Vec3 middle_mm, double diameter_mm, CystEchoes& echoes);

/// Figures of a cyst of 4 and one of 8 mm.
void addCystFigures(const CystEchoes& small, const CystEchoes& large, PointSpreadFigures& figures);

}  // namespace insonate::bench
