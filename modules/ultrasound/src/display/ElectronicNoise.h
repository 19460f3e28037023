#pragma once

#include "DisplayPlan.h"
#include "Plane.h"
#include "ReceiveKernels.h"

#include <array>
#include <cstdint>

namespace insonate::display {

/// Thermal noise of the receiver: complex, Gaussian, of the same power at all depths, so that TGC lifts it with depth
/// and frequency. It has passed the receive filter and is as wide along a scanline as the pulse; scanlines and looks,
/// being received one after another, have independent noise.
///
/// Level: at the penetration depth the speckle of average tissue is as strong as the noise. A clinical probe reaches 60
/// cm MHz divided by its frequency (Szabo and Lewin, J Ultrasound Med 2013; 32:573); there, echoes of tissue that TGC
/// levels have lost 60 kTgc_dBpcmMHz = 44 dB, which is the default of ImagingSettings::noise_dB with its sign.
class ElectronicNoise {
 public:
  ElectronicNoise(const Probe& probe, const ImagingSettings& settings, const DisplayPlan& plan);

  /// Draws where in the field the noise of one frame begins, for so many looks; the same seed gives the same noise.
  void draw(std::uint32_t seed, int looks);
  /// Hands a row's noise to `task`, for each of its looks.
  void addTo(CompoundRow& task, int row) const;

 private:
  struct Place {
    int row = 0, column = 0;
  };
  std::uint32_t time_;
  int rows_;
  Plane field_;  ///< [real, imaginary][row], larger than an image; drawn once, since that takes longer than a frame may
  std::array<Place, 3> from_{};  ///< [look]
};

}  // namespace insonate::display
