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
  /// Bilinear interpolation of one image pixel: index of the pixel (`at`), index in level_ of the first of four samples
  /// (`level`), and weights of the next samples in lateral (`x`) and axial (`z`) direction.
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
  std::vector<float> re_, im_, blurredRe_, blurredIm_, level_;  // values, index [sample][scanline]
};

}  // namespace insonate::bench
