#pragma once

#include <insonate/camera/CameraFrame.h>
#include <insonate/camera/LensModel.h>
#include <insonate/camera/TagBody.h>

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

namespace insonate {

/// Sight of a body by the camera.
enum class HandSight : std::uint8_t {
  kNeverSeen,  ///< no pose is known yet
  kTracked,    ///< measured in the latest frame
  kHidden,     ///< not seen in the latest frame; the pose stays that of the last sight
};

/// The most important reason why a body is measured badly or not at all.
enum class HandAdvice : std::uint8_t {
  kNone,
  kNotSeen,     ///< the body is not in the image, or covered
  kCovered,     ///< fewer than two tags are visible
  kAtEdge,      ///< a part of the body is outside of the image
  kTooFar,      ///< tags are too small
  kTooNear,     ///< the body fills most of the image
  kTooDark,     ///< paper and ink have nearly the same brightness
  kTooBright,   ///< paper is saturated
  kOutOfFocus,  ///< the image is blurred, although the body hardly moves
  kTooFast,     ///< the body moves so far during an exposure that its tags are smeared
};

/// Returns a sentence for the user that says what is wrong and what to do; empty for kNone.
std::string_view sentenceOf(HandAdvice advice);

/// A body as the camera sees it. Camera frame, mm, rad.
struct TrackedHand {
  HandSight sight = HandSight::kNeverSeen;
  Transform cameraFromBody;                   ///< filtered, at `time_ns`
  Transform cameraFromMeasured;               ///< pose of the body as measured in the latest frame in which it was seen
  Vec3 velocity_mmps, angularVelocity_radps;  ///< of the filter; 0 while the body is hidden
  std::int64_t time_ns = 0;                   ///< middle of the exposure of the latest frame in which the body was seen
  int tags = 0;                               ///< number of tags used
  bool isAligned = false;  ///< true: the gray values refined the pose; false: only the corners of the tags
  double blur_px = 0;      ///< width of the blur (standard deviation); 0 if not aligned
  HandAdvice advice = HandAdvice::kNotSeen;
};

/// Returns the pose at a later time by the velocity, at most 50 ms after the state; a hidden body stays where it is.
Transform predictedPose(const TrackedHand& state, std::int64_t time_ns);

/// Method of measuring a pose.
enum class PoseMethod : std::uint8_t {
  kCorners,      ///< corners of the tags only
  kIntensities,  ///< corners, then all gray values of the tags
};

/// Follows bodies with tags from frame to frame: looks for tags around the predicted place, in the whole image only if
/// the body is lost; measures the pose, refines it and filters it. Filtered poses belong to the middle of the exposure;
/// the filter adds no delay at constant velocity. Use an object on one thread at a time. All frames must have the size
/// of the lens.
class HandTracker {
 public:
  HandTracker(const LensModel& lens, std::vector<TagBody> bodies, PoseMethod method = PoseMethod::kIntensities);
  ~HandTracker();
  HandTracker(HandTracker&&) noexcept;
  HandTracker& operator=(HandTracker&&) noexcept;

  /// Measures all bodies in a frame. Frames must have increasing times; a frame that is not later than the frame
  /// before, or that has another size, is ignored. Returns states() in the order of the bodies.
  const std::vector<TrackedHand>& process(const CameraFrame& frame);
  const std::vector<TrackedHand>& states() const;
  const std::vector<TagBody>& bodies() const;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace insonate
