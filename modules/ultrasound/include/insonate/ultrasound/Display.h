#pragma once

#include <insonate/ultrasound/BeamGrid.h>
#include <insonate/ultrasound/Frames.h>

#include <cstdint>
#include <memory>

namespace insonate {

/// Converts a linear envelope to the displayed image: electronic noise > looks averaged > ringing > clutter > TGC and
/// gains > logarithm > speckle reduction > edge enhancement > persistence > gray map > scan conversion. The
/// constructor allocates everything; process() allocates nothing once the image has its size. The settings must be
/// valid for the probe (see validate()). Not for concurrent use of one object. Uses the calling thread's TBB arena.
class Display {
 public:
  Display(const Probe& probe, const ImagingSettings& settings);
  ~Display();
  Display(Display&&) noexcept;
  Display& operator=(Display&&) noexcept;

  /// The frame must have the settings' numbers of scanlines and samples, and at most their number of looks; otherwise
  /// the image is black. Amplitudes that are NaN or negative count as 0, infinite ones as white. Persistence mixes with
  /// the previous call's image. Electronic noise follows from `noiseSeed` and the settings' time_s alone: the same seed
  /// gives the same image.
  void process(const EnvelopeFrame& envelope, BModeImage& image, std::uint32_t noiseSeed = 0);
  /// Discards the previous image.
  void reset();

  struct Stages_ms {
    double compound = 0, compress = 0, smooth = 0, scanConvert = 0;
  };
  const Stages_ms& stages() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// 1 inside the field of view, 0 outside, for the image that Display makes with these settings.
std::vector<std::uint8_t> fieldOfViewMask(const Probe& probe, const ImagingSettings& settings);

/// Built-in time-gain compensation before the operator's sliders, in dB per cm and MHz of depth (there and back);
/// none where the settings leave attenuation out, and at most 120 dB.
inline constexpr double kTgc_dBpcmMHz = 0.73;

}  // namespace insonate
