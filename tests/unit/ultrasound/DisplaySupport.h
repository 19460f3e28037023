#pragma once

#include <insonate/ultrasound/Display.h>

#include <cmath>
#include <functional>

namespace insonate::test {

inline constexpr double kGrayPerDb = 255.0 / 60;  ///< of a dynamic range of 60 dB

/// Settings under which gray follows directly from amplitude: no noise, ringing or haze, no speckle reduction, no depth
/// compensation.
inline ImagingSettings bareSettings(const Probe& probe) {
  ImagingSettings settings = settingsFor(probe);
  settings.looks = 1;
  settings.speckleReduction = 0;
  settings.edgeEnhancement = 0;
  settings.grayMap = GrayMap::Linear;
  settings.effects.clutter = settings.effects.noise = settings.effects.nearField = false;
  settings.effects.attenuation = false;
  return settings;
}

/// The same amplitude everywhere that `level_dB(lateral_mm, axial_mm)` gives over unit speckle, in every look.
inline EnvelopeFrame frameOf(const Probe& probe, const ImagingSettings& settings,
                             const std::function<double(double, double)>& level_dB) {
  const BeamGrid grid(probe, settings);
  EnvelopeFrame frame;
  frame.resize(settings.scanlines, settings.samples, settings.looks);
  std::size_t i = 0;
  for (int look = 0; look < settings.looks; ++look)
    for (int k = 0; k < settings.samples; ++k)
      for (int l = 0; l < settings.scanlines; ++l) {
        const Vec3 p = grid.origin(l) + grid.direction(l) * grid.range_mm(k);
        frame.amplitude[i++] = static_cast<float>(std::pow(10, level_dB(p.x, p.z) / 20));
      }
  return frame;
}

inline EnvelopeFrame uniformFrame(const Probe& probe, const ImagingSettings& settings, double level_dB) {
  return frameOf(probe, settings, [=](double, double) { return level_dB; });
}

inline int grayAt(const BModeImage& image, double lateral_mm, double axial_mm) {
  const int column = static_cast<int>(std::lround((lateral_mm - image.left_mm) / image.pixel_mm));
  const int row = static_cast<int>(std::lround((axial_mm - image.top_mm) / image.pixel_mm));
  return image.gray.at(std::size_t(row) * image.width + column);
}

inline BModeImage display(const Probe& probe, const ImagingSettings& settings, const EnvelopeFrame& frame) {
  BModeImage image;
  Display(probe, settings).process(frame, image);
  return image;
}

}  // namespace insonate::test
