#pragma once

#include <insonate/camera/CameraFrame.h>
#include <insonate/camera/LensModel.h>
#include <insonate/camera/TagBody.h>

#include <array>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

namespace insonate {

/// A hand-like motion around a pose: three sinusoids for each axis, with frequencies from 0.2 to 1.4 times
/// `frequency_Hz`.
class SimulatedMotion {
 public:
  /// Makes the motion of a body around a pose in the camera frame. `position_mm` and `rotation_deg` are the root mean
  /// square displacements along each axis. The same seed makes the same motion.
  SimulatedMotion(const Transform& cameraFromBody, double position_mm, double rotation_deg, double frequency_Hz,
                  unsigned seed);
  /// Returns the pose at a time, s.
  Transform at(double time_s) const;

 private:
  struct Wave {
    double amplitude, frequency_radps, phase;
  };
  Transform middle_;
  std::array<std::array<Wave, 3>, 6> waves_{};
};

/// A sphere of skin in front of a body, such as a finger tip.
struct SimulatedFinger {
  Vec3 center_body;  ///< mm
  double radius_mm = 8;
};

/// A body in the view of the simulated camera.
struct SimulatedObject {
  TagBody body;
  std::function<Transform(double time_s)> cameraFromBody;
  std::vector<SimulatedFinger> fingers;
};

/// Light and sensor of the simulated camera.
struct SimulatedSensor {
  LensModel lens;
  double blur_px = 0.6;     ///< standard deviation of the lens's blur
  double white = 200;       ///< gray level of white paper that faces the light
  double noise = 1.5;       ///< standard deviation of the noise at black, gray levels
  double shotNoise = 0.02;  ///< variance of the noise for each gray level of brightness
  double exposure_ms = 8;   ///< all rows are exposed at the same time
};

/// Renders gray images of bodies with tags, as a camera would see them: distortion, motion blur, blur of the lens,
/// shading, noise, and a background with edges. Each pixel is the mean of 36 samples or more, so that an edge is off by
/// less than 0.01 pixels. Independent of the code that measures poses. Use an object on one thread at a time.
class SimulatedCamera {
 public:
  SimulatedCamera(const SimulatedSensor& sensor, unsigned seed);

  /// Renders the image whose exposure has its middle at `time_s`.
  CameraFrame render(const std::vector<SimulatedObject>& objects, double time_s);

 private:
  void renderObject(const SimulatedObject& object, double time_s, std::vector<float>& image) const;

  SimulatedSensor sensor_;
  std::vector<Vec3> rays_;  ///< through the corners of the pixels
  std::vector<float> background_;
  std::mt19937 random_;
};

}  // namespace insonate
