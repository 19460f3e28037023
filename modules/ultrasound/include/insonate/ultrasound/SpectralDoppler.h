#pragma once

#include <insonate/core/Result.h>
#include <insonate/ultrasound/ColorDoppler.h>

#include <nlohmann/json_fwd.hpp>

#include <array>
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
  /// Downward shift of the baseline in the displayed spectrum, as a fraction of its height, -0.45 to 0.45. Positive:
  /// more of the spectrum shows flow toward the probe.
  double baseline = 0;

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

/// Returns the default settings of a probe: a gate in the middle of the image.
SpectralSettings spectralSettingsFor(const Probe& probe, const ImagingSettings& settings);
/// Position of a gate in the image plane, probe frame (x, 0, z): start of its scanline at the face, middle and ends of
/// the gate, and direction of the scanline.
struct GatePlace {
  Vec3 face_mm, middle_mm, near_mm, far_mm, beam;
};
GatePlace gatePlace(const Probe& probe, const ImagingSettings& settings, const SpectralSettings& gate);

/// Computes the expected power of the echoes in a gate by velocity. One object must not be used concurrently.
class SpectralDoppler {
 public:
  /// The settings must be valid (see validate()).
  SpectralDoppler(const Probe& probe, const ImagingSettings& settings, const SpectralSettings& gate);
  ~SpectralDoppler();
  SpectralDoppler(SpectralDoppler&&) noexcept;
  SpectralDoppler& operator=(SpectralDoppler&&) noexcept;

  /// Finds the tissue and the vessels in the gate, for the spectra that follow. Call it again when pose or displacement
  /// have changed. Of `flow`, only the courses of the vessels are used.
  void hold(const AcousticScene& scene, const Transform& patientFromProbe, const PlaneDisplacement& displacement,
            const BloodFlow& flow);
  /// Computes the power in each of kSpectrumBins bins of velocity, after the wall filter, relative to the noise in one
  /// bin. Velocities beyond the Nyquist velocity alias. A spectrum has the resolution of 64 pulses. The courses of
  /// `flow` are those of hold(). `tissue_mmps` is the velocity of the tissue relative to the probe, probe frame.
  void spectrum(const BloodFlow& flow, Vec3 tissue_mmps, std::vector<double>& power);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Waterfall of spectra: gray values of consecutive spectra, [row][column], the highest velocity in the first row.
struct SpectrumImage {
  int columns = 0;
  std::vector<std::uint8_t> gray;
};

/// Returns the velocity, corrected by the angle, at the middle of a row of the displayed spectrum, from 0 (top) to
/// kSpectrumBins - 1. Above the Nyquist velocity if the baseline is shifted.
double rowVelocity_mmps(const SpectralSettings& gate, double row);
/// Converts one spectrum to a column of gray values, the highest velocity first, with speckle and noise, which depend
/// only on `seed` and on the number of the column, over a range of 35 dB.
void displaySpectrum(const std::vector<double>& power, const SpectralSettings& gate, std::uint32_t seed, int column,
                     std::array<std::uint8_t, kSpectrumBins>& gray);
/// Converts spectra, one for each column, to a waterfall.
SpectrumImage waterfallOf(const std::vector<std::vector<double>>& spectra, const SpectralSettings& gate,
                          std::uint32_t seed);

/// Velocities of a spectrum, mm/s, corrected by the angle and positive toward the probe: the mean, weighted by power
/// above the noise, and the velocity whose absolute value 95 % of this power does not exceed. 0 if no bin exceeds the
/// noise.
struct SpectrumVelocities {
  double mean_mmps = 0, envelope_mmps = 0;
};
SpectrumVelocities velocitiesOf(const std::vector<double>& power, const SpectralSettings& gate);

/// The sound of a gate: noise with the spectrum of the echoes. Frequencies are those of the Doppler shift, of flow in
/// both directions. The sound depends only on the spectra and the seed. One object must not be used concurrently.
class DopplerSound {
 public:
  DopplerSound(double prf_Hz, int rate_Hz, std::uint32_t seed);
  ~DopplerSound();
  DopplerSound(DopplerSound&&) noexcept;
  DopplerSound& operator=(DopplerSound&&) noexcept;

  /// Appends `seconds` of sound for a spectrum, at most 0.05, in steps whose sum is exact; `gain_dB` is that of the
  /// display. Samples are limited to -1 to 1.
  void append(const std::vector<double>& power, double gain_dB, double seconds, std::vector<float>& samples);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace insonate
