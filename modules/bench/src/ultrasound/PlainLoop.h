#pragma once

#include <insonate/simulator/Imager.h>

#include <array>
#include <vector>

namespace insonate::bench {

/// A simple single-threaded image simulation, whose speed is compared with that of the engines: one scalar loop over
/// planes, scanlines and samples with nearest-label look-up, attenuation and hashed complex noise per sample; then a
/// separable Gaussian point-spread function that widens with distance from the focus, magnitude, logarithm, and
/// bilinear scan conversion. It has no boundaries, layers, textures, shadows, compounding, clutter or smoothing.
class PlainLoop {
 public:
  PlainLoop(const PatientCase& patient, const ImagingSetup& setup);
  void render(const Transform& patientFromProbe, BModeImage& image);

 private:
  /// A pixel inside the field of view for scan conversion: indices of the pixel and of the sample before it, and
  /// weights of the next sample along each axis.
  struct Pixel {
    std::size_t at, level;
    float x, z;
  };
  void layOut();
  void scatter(const Transform& patientFromProbe);
  void blurAxially();
  void blurLaterally();
  void convert(BModeImage& image) const;

  const PatientCase& patient_;
  const ImagingSetup& setup_;
  BeamGrid grid_;
  std::array<float, kLabelCount> echo_{},
      loss_{};  // per label: echo amplitude, and fraction of the amplitude that remains after one sample
  std::vector<float> axialKernel_;
  std::vector<std::vector<float>> lateralKernel_;  // lateral blur kernel for each depth sample
  std::vector<Pixel> pixels_;
  std::vector<float> re_, im_, blurredRe_, blurredIm_, level_;  // [sample][scanline]
};

}  // namespace insonate::bench
