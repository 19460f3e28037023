#pragma once

#include <insonate/ultrasound/Frames.h>

#include <span>
#include <vector>

namespace insonate::test {

/// Part of a frame: samples and scanlines from `first` up to but without `end`.
struct Window {
  int firstSample = 0, endSample = 0, firstLine = 0, endLine = 0;
};
Window wholeFrame(const EnvelopeFrame& frame);

std::vector<double> valuesIn(const EnvelopeFrame& frame, const Window& window, int look = 0);

double mean(std::span<const double> values);
double standardDeviation(std::span<const double> values);
double rms(std::span<const double> values);
double correlation(std::span<const double> a, std::span<const double> b);
double decibel(double amplitude);
std::vector<double> decibels(std::span<const double> amplitudes);
/// Least-squares slope of y over x.
double slope(std::span<const double> x, std::span<const double> y);

/// One scanline from the face down; one sample across all scanlines.
std::vector<double> scanline(const EnvelopeFrame& frame, int line, int look = 0);
std::vector<double> acrossLines(const EnvelopeFrame& frame, int sample, int look = 0);
/// Each scanline's mean over the samples of a window.
std::vector<double> lineMeans(const EnvelopeFrame& frame, const Window& window, int look = 0);
/// Each scanline's sum over all samples.
std::vector<double> lineSums(const EnvelopeFrame& frame, int look = 0);

struct Peak {
  double index = 0;  ///< fractional
  double value = 0;
  double fwhm = 0;  ///< in indices; 0 where the profile does not fall to half on both sides
};
/// The highest value, refined by a parabola, and the full width at half of it.
Peak peakOf(std::span<const double> profile);

/// Fractional index where the profile first crosses `level`, going from `from` toward `to`; negative if it does not.
double crossing(std::span<const double> profile, double level, int from, int to);

/// RMS of the difference over the RMS of `truth`, all looks.
double relativeError(const EnvelopeFrame& frame, const EnvelopeFrame& truth);
double correlation(const EnvelopeFrame& a, const EnvelopeFrame& b);
double largest(const EnvelopeFrame& frame);
bool allFinite(const EnvelopeFrame& frame);
bool identical(const EnvelopeFrame& a, const EnvelopeFrame& b);

}  // namespace insonate::test
