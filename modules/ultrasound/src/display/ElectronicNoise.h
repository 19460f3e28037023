#pragma once

#include "DisplayPlan.h"
#include "Plane.h"
#include "ReceiveKernels.h"

#include <cstdint>
#include <memory>

namespace insonate::display {

/// A field of electronic noise with unit power, larger than an image. The field is computed once, since this takes
/// longer than a frame may take.
struct NoiseField {
  struct Shape {
    int rows, columns, looks;
    double nodeDistance, growth;  ///< nodeDistance: distance between the nodes of the noise's splines at the face, in
                                  ///< samples; growth: its growth per sample of depth
    bool operator==(const Shape&) const = default;
  } shape;
  Plane values;  ///< rows of the noise's power, and of twice its in-phase part
};

/// Thermal noise of the receiver: complex, Gaussian, with the same power at all depths, so that TGC amplifies the noise
/// with depth and frequency. The noise has passed the receive filter, so that its correlation length along a scanline
/// is that of the pulse. Scanlines and looks are received one after another and therefore have independent noise.
///
/// Level: at the penetration depth the speckle of average tissue is as strong as the noise. A clinical probe reaches 60
/// cm MHz divided by its frequency (Szabo and Lewin, J Ultrasound Med 2013; 32:573). At this depth, echoes of tissue
/// whose attenuation TGC compensates exactly have lost 60 kTgc_dBpcmMHz = 44 dB. The default of
/// ImagingSettings::noise_dB is therefore -44 dB.
class ElectronicNoise {
 public:
  ElectronicNoise(const Probe& probe, const ImagingSettings& settings, const DisplayPlan& plan);

  /// Selects the part of the noise field for one frame; the same seed gives the same noise.
  void draw(std::uint32_t seed);
  /// Returns the noise of the mean of all looks (renderings with independent speckle) in one row of samples.
  NoiseRow row(int sample) const;

 private:
  std::uint32_t time_;
  float amplitude_;
  std::shared_ptr<const NoiseField> field_;
  int firstRow_ = 0, firstColumn_ = 0;
};

}  // namespace insonate::display
