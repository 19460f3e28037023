#pragma once

#include <insonate/ultrasound/BeamGrid.h>
#include <insonate/ultrasound/Frames.h>

#include <cstdint>
#include <memory>

namespace insonate {

/// Converts a linear envelope to the displayed image: electronic noise > averaging of the looks (several renderings of
/// one frame with independent speckle) > ringing of the elements > haze > TGC and gains > logarithm > speckle reduction
/// > edge enhancement > persistence > gray map > scan conversion. The constructor allocates everything; process()
/// allocates nothing once the image has its size. The settings must be valid for the probe (see validate()). One object
/// must not be used concurrently. Uses the calling thread's TBB arena.
class Display {
 public:
  Display(const Probe& probe, const ImagingSettings& settings);
  ~Display();
  Display(Display&&) noexcept;
  Display& operator=(Display&&) noexcept;

  /// Processes one frame. The frame must have as many scanlines and samples as the settings, and not more looks;
  /// otherwise the image is black. Amplitudes that are NaN or negative count as 0, infinite amplitudes as white.
  /// Persistence mixes the image with that of the previous call. Electronic noise depends only on `noiseSeed` and
  /// ImagingSettings::time_s.
  void process(const EnvelopeFrame& envelope, BModeImage& image, std::uint32_t noiseSeed = 0);
  /// Discards the previous image, so that the next image has no persistence.
  void reset();

  struct Stages_ms {
    double compound = 0, compress = 0, smooth = 0, scanConvert = 0;
  };
  const Stages_ms& stages() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Returns a mask of the image that Display makes with these settings: 1 inside the field of view, 0 outside.
std::vector<std::uint8_t> fieldOfViewMask(const Probe& probe, const ImagingSettings& settings);

/// Built-in time-gain compensation, without the operator's sliders, in dB per cm of depth and MHz (two-way). The
/// compensation is limited to 120 dB, and is off if the settings switch attenuation off.
inline constexpr double kTgc_dBpcmMHz = 0.73;

}  // namespace insonate
