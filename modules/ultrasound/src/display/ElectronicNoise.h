#pragma once

#include "DisplayPlan.h"
#include "Plane.h"
#include "ReceiveKernels.h"

#include <cstdint>
#include <memory>

namespace insonate::display {

/// Noise of unit power, larger than an image. It is drawn once, since that takes longer than a frame may.
struct NoiseField {
  struct Shape {
    int rows, columns, looks;
    double nodeDistance, growth;  ///< between the nodes of its splines at the face, in samples, and per sample of depth
    bool operator==(const Shape&) const = default;
  } shape;
  Plane values;  ///< [power, twice in phase][row]
};

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

  /// Draws where in the field the noise of one frame begins; the same seed gives the same noise.
  void draw(std::uint32_t seed);
  /// Noise of the looks' mean in one row of samples.
  NoiseRow row(int sample) const;

 private:
  std::uint32_t time_;
  float amplitude_;
  std::shared_ptr<const NoiseField> field_;
  int firstRow_ = 0, firstColumn_ = 0;
};

}  // namespace insonate::display
