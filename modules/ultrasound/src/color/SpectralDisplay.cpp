#include <insonate/core/Hash.h>
#include <insonate/ultrasound/SpectralDoppler.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace insonate {
namespace {

constexpr double kSpectrumRange_dB = 35;

/// Number of rows by which the baseline is shifted.
int shiftOf(const SpectralSettings& gate) {
  return static_cast<int>(std::lround(gate.baseline * kSpectrumBins));
}

/// Signals beyond this size are compressed.
float limited(double sample) {
  return static_cast<float>(std::tanh(sample));
}

}  // namespace

double rowVelocity_mmps(const SpectralSettings& gate, double row) {
  return nyquistVelocity_mmps(gate) * (2 * (kSpectrumBins - 1 - row + shiftOf(gate)) / kSpectrumBins - 1);
}

void displaySpectrum(const std::vector<double>& power, const SpectralSettings& gate, std::uint32_t seed, int column,
                     std::array<std::uint8_t, kSpectrumBins>& gray) {
  const int shift = shiftOf(gate);
  for (int row = 0; row < kSpectrumBins; ++row) {
    const int bin = (kSpectrumBins - 1 - row + shift + kSpectrumBins) % kSpectrumBins;
    // The power of a spectrum has two degrees of freedom; neighboring spectra overlap, which averages two of them.
    double level = 0;
    for (int part = 0; part < 2; ++part) {
      const std::uint32_t hash = hashNode(column, bin, part, seed);
      level -= 0.5 * std::log((hash + 0.5) / 4294967296.0);
    }
    const double level_dB = 10 * std::log10((power[bin] + 1) * level) + gate.gain_dB;
    gray[row] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(level_dB / kSpectrumRange_dB, 0.0, 1.0)));
  }
}

SpectrumImage waterfallOf(const std::vector<std::vector<double>>& spectra, const SpectralSettings& gate,
                          std::uint32_t seed) {
  SpectrumImage image;
  image.columns = static_cast<int>(spectra.size());
  image.gray.resize(spectra.size() * kSpectrumBins);
  std::array<std::uint8_t, kSpectrumBins> gray{};
  for (std::size_t column = 0; column < spectra.size(); ++column) {
    displaySpectrum(spectra[column], gate, seed, static_cast<int>(column), gray);
    for (int row = 0; row < kSpectrumBins; ++row) image.gray[std::size_t(row) * spectra.size() + column] = gray[row];
  }
  return image;
}

SpectrumVelocities velocitiesOf(const std::vector<double>& power, const SpectralSettings& gate) {
  double sum = 0, moment = 0;
  const auto above = [&](int bin) { return power[bin] > 1 ? power[bin] : 0; };
  for (int bin = 0; bin < kSpectrumBins; ++bin) {
    sum += above(bin);
    moment += above(bin) * binVelocity_mmps(gate, bin);
  }
  if (sum == 0) return {};
  SpectrumVelocities velocities{moment / sum, 0};
  // From zero outward on the side of the mean.
  const int sign = moment < 0 ? -1 : 1;
  double side = 0, passed = 0;
  for (int o = 0; o < kSpectrumBins / 2; ++o) side += above(kSpectrumBins / 2 + sign * o);
  for (int o = 0; o < kSpectrumBins / 2; ++o) {
    passed += above(kSpectrumBins / 2 + sign * o);
    velocities.envelope_mmps = binVelocity_mmps(gate, kSpectrumBins / 2 + sign * o);
    if (passed >= 0.95 * side) break;
  }
  return velocities;
}

/// Blocks of noise with the present spectrum overlap, so that the spectrum changes smoothly.
struct DopplerSound::Impl {
  using Complex = std::complex<double>;

  Impl(double prf_Hz, int rate_Hz, std::uint32_t seed);
  void addBlock(const std::vector<double>& power, double amplitude);

  double prf_Hz, rate_Hz;
  std::uint32_t seed;
  std::vector<double> window;
  std::vector<Complex> turns;  ///< exp(2 pi i k / kSpectrumBins)
  std::vector<double> echo;    ///< sound at the rate of the pulses, from the next sample on
  double sinceEcho = 0;        ///< position of the next sample after the first of `echo`, in pulses
  double samplesDue = 0;       ///< part of a sample that is still due
  std::int32_t block = 0;
};

DopplerSound::Impl::Impl(double prf, int rate, std::uint32_t of) : prf_Hz(prf), rate_Hz(rate), seed(of) {
  constexpr double kBlock_s = 0.03;
  const int length = std::clamp(static_cast<int>(std::lround(kBlock_s * prf_Hz)), 16, kSpectrumBins);
  for (int i = 0; i < length; ++i) window.push_back(0.5 - 0.5 * std::cos(2 * std::numbers::pi * (i + 0.5) / length));
  for (int k = 0; k < kSpectrumBins; ++k) turns.push_back(std::polar(1.0, 2 * std::numbers::pi * k / kSpectrumBins));
}

/// Adds noise whose bins have random phases and normally distributed amplitudes.
void DopplerSound::Impl::addBlock(const std::vector<double>& power, double amplitude) {
  const auto first = static_cast<std::size_t>(sinceEcho);
  echo.resize(std::max(echo.size(), first + window.size() + 1));
  ++block;
  for (int bin = 0; bin < kSpectrumBins; ++bin) {
    const double u = (hashNode(block, bin, 0, seed) + 0.5) / 4294967296.0;
    const double phase = 2 * std::numbers::pi * unitInterval(hashNode(block, bin, 1, seed));
    const Complex wave = std::polar(amplitude * std::sqrt(-(power[bin] + 1) * std::log(u)), phase);
    // Bin kSpectrumBins / 2 has the frequency 0.
    const int step = (bin + kSpectrumBins / 2) % kSpectrumBins;
    for (std::size_t i = 0, turn = 0; i < window.size(); ++i, turn = (turn + step) % kSpectrumBins)
      echo[first + i] += window[i] * (wave.real() * turns[turn].real() - wave.imag() * turns[turn].imag());
  }
}

DopplerSound::DopplerSound(double prf_Hz, int rate_Hz, std::uint32_t seed)
    : impl_(std::make_unique<Impl>(prf_Hz, rate_Hz, seed)) {}
DopplerSound::~DopplerSound() = default;
DopplerSound::DopplerSound(DopplerSound&&) noexcept = default;
DopplerSound& DopplerSound::operator=(DopplerSound&&) noexcept = default;

void DopplerSound::append(const std::vector<double>& power, double gain_dB, double seconds,
                          std::vector<float>& samples) {
  // The noise of the receiver alone is just audible.
  constexpr double kNoiseLevel = 0.008;
  Impl& impl = *impl_;
  const double overlaps = std::max(1.0, double(impl.window.size()) / (seconds * impl.prf_Hz)) * 3 / 8;
  const double level = kNoiseLevel * std::pow(10, gain_dB / 20) / std::sqrt(kSpectrumBins * overlaps / 2);
  impl.addBlock(power, level);
  impl.samplesDue += seconds * impl.rate_Hz;
  for (; impl.samplesDue >= 1; impl.samplesDue -= 1) {
    const auto low = static_cast<std::size_t>(impl.sinceEcho);
    const double part = impl.sinceEcho - double(low);
    impl.echo.resize(std::max(impl.echo.size(), low + 2));
    samples.push_back(limited(impl.echo[low] + part * (impl.echo[low + 1] - impl.echo[low])));
    impl.sinceEcho += impl.prf_Hz / impl.rate_Hz;
  }
  const auto played = static_cast<std::size_t>(impl.sinceEcho);
  impl.echo.erase(impl.echo.begin(), impl.echo.begin() + std::ptrdiff_t(std::min(played, impl.echo.size())));
  impl.sinceEcho -= double(played);
}

}  // namespace insonate
