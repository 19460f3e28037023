#include "conformance/Measure.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace insonate::test {

Window wholeFrame(const EnvelopeFrame& frame) {
  return {0, frame.samples, 0, frame.scanlines};
}

std::vector<double> valuesIn(const EnvelopeFrame& frame, const Window& w, int look) {
  std::vector<double> values;
  for (int m = w.firstSample; m < w.endSample; ++m)
    for (int l = w.firstLine; l < w.endLine; ++l)
      values.push_back(frame.look(look)[std::size_t(m) * frame.scanlines + l]);
  return values;
}

double mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double rms(std::span<const double> values) {
  return std::sqrt(std::inner_product(values.begin(), values.end(), values.begin(), 0.0) /
                   static_cast<double>(values.size()));
}

double standardDeviation(std::span<const double> values) {
  const double m = mean(values);
  double sum = 0;
  for (const double v : values) sum += (v - m) * (v - m);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double correlation(std::span<const double> a, std::span<const double> b) {
  const double ma = mean(a), mb = mean(b);
  double ab = 0, aa = 0, bb = 0;
  for (std::size_t n = 0; n < a.size(); ++n) {
    ab += (a[n] - ma) * (b[n] - mb);
    aa += (a[n] - ma) * (a[n] - ma);
    bb += (b[n] - mb) * (b[n] - mb);
  }
  return ab / std::sqrt(aa * bb);
}

double decibel(double amplitude) {
  return 20 * std::log10(amplitude);
}

std::vector<double> decibels(std::span<const double> amplitudes) {
  std::vector<double> dB;
  for (const double a : amplitudes) dB.push_back(decibel(a));
  return dB;
}

double slope(std::span<const double> x, std::span<const double> y) {
  const double mx = mean(x), my = mean(y);
  double xy = 0, xx = 0;
  for (std::size_t n = 0; n < x.size(); ++n) xy += (x[n] - mx) * (y[n] - my), xx += (x[n] - mx) * (x[n] - mx);
  return xy / xx;
}

std::vector<double> scanline(const EnvelopeFrame& frame, int line, int look) {
  return valuesIn(frame, {0, frame.samples, line, line + 1}, look);
}

std::vector<double> acrossLines(const EnvelopeFrame& frame, int sample, int look) {
  return valuesIn(frame, {sample, sample + 1, 0, frame.scanlines}, look);
}

std::vector<double> lineMeans(const EnvelopeFrame& frame, const Window& w, int look) {
  std::vector<double> means;
  for (int l = w.firstLine; l < w.endLine; ++l)
    means.push_back(mean(valuesIn(frame, {w.firstSample, w.endSample, l, l + 1}, look)));
  return means;
}

std::vector<double> lineSums(const EnvelopeFrame& frame, int look) {
  std::vector<double> sums = lineMeans(frame, wholeFrame(frame), look);
  for (double& s : sums) s *= frame.samples;
  return sums;
}

Peak peakOf(std::span<const double> profile) {
  const auto top = std::max_element(profile.begin(), profile.end()) - profile.begin();
  const auto last = static_cast<std::ptrdiff_t>(profile.size()) - 1;
  Peak peak{static_cast<double>(top), profile[top], 0};
  if (top > 0 && top < last) {
    const double before = profile[top - 1], after = profile[top + 1], bend = before - 2 * profile[top] + after;
    if (bend < 0) {
      const double shift = 0.5 * (before - after) / bend;
      peak.index += shift;
      peak.value -= 0.25 * (before - after) * shift;
    }
  }
  const double left = crossing(profile, peak.value / 2, static_cast<int>(top), 0);
  const double right = crossing(profile, peak.value / 2, static_cast<int>(top), static_cast<int>(last));
  if (left >= 0 && right >= 0) peak.fwhm = right - left;
  return peak;
}

double crossing(std::span<const double> profile, double level, int from, int to) {
  const int step = to > from ? 1 : -1;
  for (int n = from; n != to; n += step) {
    const double here = profile[n] - level, next = profile[n + step] - level;
    if (here == 0) return n;
    if ((here < 0) != (next < 0)) return n + step * here / (here - next);
  }
  return -1;
}

double relativeError(const EnvelopeFrame& frame, const EnvelopeFrame& truth) {
  double error2 = 0, truth2 = 0;
  for (std::size_t n = 0; n < truth.amplitude.size(); ++n) {
    const double difference = double(frame.amplitude[n]) - truth.amplitude[n];
    error2 += difference * difference;
    truth2 += double(truth.amplitude[n]) * truth.amplitude[n];
  }
  return truth2 > 0 ? std::sqrt(error2 / truth2) : std::sqrt(error2);
}

double correlation(const EnvelopeFrame& a, const EnvelopeFrame& b) {
  const std::vector<double> va(a.amplitude.begin(), a.amplitude.end()), vb(b.amplitude.begin(), b.amplitude.end());
  return correlation(va, vb);
}

double largest(const EnvelopeFrame& frame) {
  return frame.amplitude.empty() ? 0 : *std::max_element(frame.amplitude.begin(), frame.amplitude.end());
}

bool allFinite(const EnvelopeFrame& frame) {
  return std::all_of(frame.amplitude.begin(), frame.amplitude.end(), [](float a) { return std::isfinite(a); });
}

bool identical(const EnvelopeFrame& a, const EnvelopeFrame& b) {
  return a.scanlines == b.scanlines && a.samples == b.samples && a.looks == b.looks && a.amplitude == b.amplitude;
}

}  // namespace insonate::test
