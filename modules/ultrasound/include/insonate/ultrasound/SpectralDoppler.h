#pragma once

#include <insonate/core/Result.h>
#include <insonate/ultrasound/ColorDoppler.h>

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace insonate {

/// Settings of pulsed-wave Doppler: a gate on one scanline, and the spectrum of the velocities in it.
struct SpectralSettings {
  double across = 0.5;        ///< scanline, as a fraction of the field of view from its left edge, at the face; 0 to 1
  double range_mm = 20;       ///< range of the middle of the gate from the face, along the scanline
  double gate_mm = 3;         ///< length of the gate, 0.5 to 20
  double steering_deg = 0;    ///< angle of the scanline toward +x, linear probes only; -20 to 20
  double frequency_MHz = 5;   ///< frequency of the transmitted pulses, 1 to 20
  double prf_Hz = 5000;       ///< pulse repetition frequency, 500 to 20000
  double wallFilter_Hz = 80;  ///< cutoff of the filter that suppresses slow tissue, 0 to half the PRF
  double angle_deg = 0;       ///< angle between beam and flow, by which velocities are corrected; 0 to 80
  double gain_dB = 0;         ///< gain of the displayed spectrum, -30 to 30

  bool operator==(const SpectralSettings&) const = default;
};

Result<SpectralSettings> spectralFromJson(const nlohmann::json& overrides, SpectralSettings base);
nlohmann::json jsonOf(const SpectralSettings& gate);
/// Checks ranges, that the gate lies within the depth of the image, and that its echo arrives before the next pulse.
Result<void> validate(const SpectralSettings& gate, const Probe& probe, const ImagingSettings& settings);
/// Returns the velocity, corrected by the angle, above which velocities alias, mm/s.
double nyquistVelocity_mmps(const SpectralSettings& gate);

/// Number of velocities in a spectrum.
inline constexpr int kSpectrumBins = 256;
/// Returns the velocity of the middle of a bin, corrected by the angle; positive: toward the probe.
double binVelocity_mmps(const SpectralSettings& gate, int bin);

/// Computes the expected power of the echoes in a gate by velocity. One object must not be used concurrently.
class SpectralDoppler {
 public:
  /// The settings must be valid (see validate()).
  SpectralDoppler(const Probe& probe, const ImagingSettings& settings, const SpectralSettings& gate);
  ~SpectralDoppler();
  SpectralDoppler(SpectralDoppler&&) noexcept;
  SpectralDoppler& operator=(SpectralDoppler&&) noexcept;

  /// Computes the power in each of kSpectrumBins bins of velocity, after the wall filter, relative to the noise in one
  /// bin. Velocities beyond the Nyquist velocity alias. A spectrum has the resolution of 64 pulses.
  void spectrum(const AcousticScene& scene, const Transform& patientFromProbe, const PlaneDisplacement& displacement,
                const ColorMotion& motion, std::vector<double>& power);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Waterfall of spectra: gray values of consecutive spectra, [bin][column], the highest velocity in the first row.
struct SpectrumImage {
  int columns = 0;
  std::vector<std::uint8_t> gray;
};

/// Converts spectra, one for each column, to a waterfall with speckle and noise, which depend only on `seed`, over a
/// range of 35 dB.
SpectrumImage waterfallOf(const std::vector<std::vector<double>>& spectra, const SpectralSettings& gate,
                          std::uint32_t seed);

/// Velocities of a spectrum, mm/s, corrected by the angle and positive toward the probe: the mean, weighted by power
/// above the noise, and the velocity whose absolute value 95 % of this power does not exceed. 0 if no bin exceeds the
/// noise.
struct SpectrumVelocities {
  double mean_mmps = 0, envelope_mmps = 0;
};
SpectrumVelocities velocitiesOf(const std::vector<double>& power, const SpectralSettings& gate);

}  // namespace insonate
