#include "PatternAlignment.h"

#include <insonate/camera/BodyPose.h>
#include <insonate/camera/HandFilter.h>
#include <insonate/camera/HandTracker.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace insonate {
namespace {

using camera::AlignedPose;
using camera::Motion;

constexpr double kUsualBlur_px = 0.7;
constexpr int kFramesUntilLost = 5;

/// Memory of one body from frame to frame.
struct Track {
  HandFilter filter;
  double blur_px = kUsualBlur_px;
  int hiddenFrames = kFramesUntilLost;
  int alignedTags = 0, framesSinceCorners = 0;
  double error = 1, surprise_px = 1e9;  ///< of the latest frame: error of the alignment; distance from the prediction
  /// Tells whether the prediction is close enough for an alignment without corners. Corners are measured from time to
  /// time nevertheless, so that an alignment that has slipped does not last.
  bool isPredictable() const {
    constexpr double kNear_px = 1.2;
    constexpr int kMaxFrames = 8, kLeastTags = 3;
    return hiddenFrames == 0 && surprise_px < kNear_px && framesSinceCorners < kMaxFrames && alignedTags >= kLeastTags;
  }
  bool isLost() const { return hiddenFrames >= kFramesUntilLost; }
};

/// Bounds of a body in the image; no value if a part of it is behind the camera.
struct Bounds {
  double left = 1e9, top = 1e9, right = -1e9, bottom = -1e9;
  double size() const { return std::max(right - left, bottom - top); }
};

std::optional<Bounds> boundsOf(const TagBody& body, const LensModel& lens, const Transform& cameraFromBody) {
  Bounds b;
  for (const Vec3& vertex : body.vertices_mm) {
    const auto p = project(lens, cameraFromBody * vertex);
    if (!p) return std::nullopt;
    b.left = std::min(b.left, p->x), b.right = std::max(b.right, p->x);
    b.top = std::min(b.top, p->y), b.bottom = std::max(b.bottom, p->y);
  }
  return b;
}

FrameBox around(const Bounds& bounds, int hiddenFrames) {
  const int margin = int(16 + bounds.size() * (0.15 + 0.2 * hiddenFrames));
  const int left = int(bounds.left) - margin, top = int(bounds.top) - margin;
  return {left, top, int(bounds.right) + margin - left, int(bounds.bottom) + margin - top};
}

Motion motionDuring(const HandFilter& filter, std::int64_t duration_ns) {
  const double dt = 1e-9 * double(duration_ns);
  const Vec3 v = filter.velocity_mmps() * dt, w = filter.angularVelocity_radps() * dt;
  return {{v.x, v.y, v.z, w.x, w.y, w.z}};
}

/// A pose measured in one frame.
struct Measured {
  Transform cameraFromBody;
  std::array<double, 36> covariance{};
  int tags = 0;
  bool isAligned = false;
  double blur_px = 0, white = 0, black = 0, error = 1;
  bool hasCorners = false;
};

std::optional<Measured> measuredFrom(const std::optional<BodyPose>& corners,
                                     const std::optional<AlignedPose>& aligned) {
  if (aligned) {
    Measured m{aligned->cameraFromBody, camera::inverted(aligned->information).values,
               aligned->tags,           true,
               aligned->blur_px,        aligned->white,
               aligned->black,          aligned->error,
               corners.has_value()};
    // A covariance of zero marks equations without a solution.
    if (m.covariance[0] > 0) return m;
  }
  if (!corners) return std::nullopt;
  Measured m{corners->cameraFromBody, corners->covariance, corners->tags};
  m.hasCorners = true;
  return m;
}

HandAdvice adviceFor(const Measured& m, const Track& track, const Bounds& bounds, const LensModel& lens,
                     std::int64_t exposure_ns) {
  constexpr double kEdge_px = 2, kNearShare = 0.8, kSmall_px = 45;
  constexpr double kDarkContrast = 40, kSaturated = 252, kBlurred_px = 1.8, kSmeared_px = 9, kUsualExposure_ns = 15e6;
  if (bounds.size() > kNearShare * lens.height) return HandAdvice::kTooNear;
  if (bounds.left < kEdge_px || bounds.top < kEdge_px || bounds.right > lens.width - kEdge_px ||
      bounds.bottom > lens.height - kEdge_px)
    return HandAdvice::kAtEdge;
  const double pixelPerMm = lens.fx_px / std::max(1.0, m.cameraFromBody.offset.z);
  const double path_px = norm(track.filter.velocity_mmps()) * 1e-9 *
                         (exposure_ns > 0 ? double(exposure_ns) : kUsualExposure_ns) * pixelPerMm;
  if (path_px > kSmeared_px) return HandAdvice::kTooFast;
  if (m.isAligned && m.white - m.black < kDarkContrast) return HandAdvice::kTooDark;
  if (m.isAligned && m.white > kSaturated) return HandAdvice::kTooBright;
  if (m.isAligned && m.blur_px > kBlurred_px && path_px < m.blur_px) return HandAdvice::kOutOfFocus;
  if (bounds.size() < kSmall_px) return HandAdvice::kTooFar;
  return m.tags < 2 ? HandAdvice::kCovered : HandAdvice::kNone;
}

/// Advice for a body that is not seen.
HandAdvice adviceWithoutBody(const CameraFrame& frame) {
  constexpr std::size_t kEvery = 97;  // of the pixels; coprime to the usual widths
  constexpr double kDark = 25;
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < frame.pixels.size(); i += kEvery) sum += frame.pixels[i], ++count;
  return sum < kDark * count ? HandAdvice::kTooDark : HandAdvice::kNotSeen;
}

}  // namespace

std::string_view sentenceOf(HandAdvice advice) {
  switch (advice) {
    case HandAdvice::kNone:
      return "";
    case HandAdvice::kNotSeen:
      return "The camera does not see the body. Hold it in front of the camera.";
    case HandAdvice::kCovered:
      return "Fingers cover most tags. Hold the body by its handle.";
    case HandAdvice::kAtEdge:
      return "The body leaves the camera's image. Move it toward the middle of the image.";
    case HandAdvice::kTooFar:
      return "The body is too far away. Move it closer to the camera.";
    case HandAdvice::kTooNear:
      return "The body is too close to the camera. Move it farther away.";
    case HandAdvice::kTooDark:
      return "The image is too dark. Turn on a light that shines on the body.";
    case HandAdvice::kTooBright:
      return "The paper is overexposed. Reduce the light, or the exposure of the camera.";
    case HandAdvice::kOutOfFocus:
      return "The image is out of focus. Clean the lens, or set the focus of the camera.";
    case HandAdvice::kTooFast:
      return "The body moves too fast. Move it more slowly, or add light for a shorter exposure.";
  }
  return "";
}

Transform predictedPose(const TrackedHand& state, std::int64_t time_ns) {
  if (state.sight != HandSight::kTracked) return state.cameraFromBody;
  const double dt = 1e-9 * double(std::min(time_ns - state.time_ns, HandFilter::kMaxPrediction_ns));
  const Vec3 v = state.velocity_mmps * dt, w = state.angularVelocity_radps * dt;
  return camera::movedBy(state.cameraFromBody, {{v.x, v.y, v.z, w.x, w.y, w.z}});
}

struct HandTracker::Work {
  LensModel lens;
  std::vector<TagBody> bodies;
  PoseMethod method;
  camera::PatternAlignment alignment;
  TagDetector detector;
  std::vector<TrackedHand> states;
  std::vector<Track> tracks;
  std::vector<TagDetection> everywhere, nearby;
  std::int64_t time_ns = INT64_MIN;
  bool isSearched = false;  ///< `everywhere` belongs to the present frame

  const std::vector<TagDetection>& detect(const CameraFrame& frame, std::size_t index);
  std::optional<Measured> measure(const CameraFrame& frame, std::size_t index);
  std::optional<AlignedPose> alignedFrom(const CameraFrame& frame, std::size_t index,
                                         const std::vector<Transform>& starts, const Motion& path, int leastTags);
  void update(const CameraFrame& frame, std::size_t index);
};

const std::vector<TagDetection>& HandTracker::Work::detect(const CameraFrame& frame, std::size_t index) {
  const Track& track = tracks[index];
  if (!track.isLost()) {
    const auto bounds = boundsOf(bodies[index], lens, track.filter.predictedAt(frame.time_ns));
    nearby.clear();
    if (bounds) detector.detect(frame.view(), around(*bounds, track.hiddenFrames), 1, nearby);
    return nearby;
  }
  if (!isSearched) {
    isSearched = true;
    everywhere.clear();
    constexpr int kLargeWidth = 1400;
    detector.detect(frame.view(), {0, 0, frame.width, frame.height}, frame.width < kLargeWidth ? 1 : 2, everywhere);
  }
  return everywhere;
}

std::optional<Measured> HandTracker::Work::measure(const CameraFrame& frame, std::size_t index) {
  const Track& track = tracks[index];
  std::optional<Transform> expected;
  if (!track.isLost()) expected = track.filter.predictedAt(frame.time_ns);
  // A hidden body's velocity is out of date.
  const Motion path = track.hiddenFrames > 0 ? Motion{} : motionDuring(track.filter, frame.exposure_ns);
  if (method == PoseMethod::kIntensities && expected && track.isPredictable()) {
    const auto aligned =
        alignment.align(frame.view(), bodies[index], {*expected, path, track.blur_px, true}, track.alignedTags - 1);
    constexpr double kSimilar = 1.3, kSlack = 0.01;
    if (aligned && aligned->error < kSimilar * track.error + kSlack) return measuredFrom(std::nullopt, aligned);
  }
  const auto corners = estimatePose(bodies[index], lens, detect(frame, index), expected);
  // One of two possible poses would be a guess.
  if (track.isLost() && (!corners || corners->isAmbiguous)) return std::nullopt;
  if (method == PoseMethod::kCorners) return measuredFrom(corners, std::nullopt);
  std::vector<Transform> starts;
  if (corners) starts.push_back(corners->cameraFromBody);
  if (expected && track.hiddenFrames <= 1) starts.push_back(*expected);
  // The corners of a single tag are a worse start than the prediction.
  if (corners && corners->tags < 2) std::ranges::reverse(starts);
  const auto aligned = alignedFrom(frame, index, starts, path, corners ? 1 : 2);
  if (!aligned && corners && corners->tags < 2) return std::nullopt;
  return measuredFrom(corners, aligned);
}

std::optional<AlignedPose> HandTracker::Work::alignedFrom(const CameraFrame& frame, std::size_t index,
                                                          const std::vector<Transform>& starts, const Motion& path,
                                                          int leastTags) {
  constexpr int kManyTags = 3;
  std::optional<AlignedPose> best;
  for (const Transform& start : starts) {
    const auto aligned = alignment.align(frame.view(), bodies[index], {start, path, tracks[index].blur_px}, leastTags);
    if (aligned && (!best || aligned->tags > best->tags)) best = aligned;
    if (best && best->tags >= kManyTags) break;
  }
  return best;
}

void HandTracker::Work::update(const CameraFrame& frame, std::size_t index) {
  Track& track = tracks[index];
  TrackedHand& state = states[index];
  const auto measured = measure(frame, index);
  const auto bounds = measured ? boundsOf(bodies[index], lens, measured->cameraFromBody) : std::nullopt;
  if (!bounds) {
    track.hiddenFrames = std::min(track.hiddenFrames + 1, kFramesUntilLost);
    if (state.sight == HandSight::kTracked) state.sight = HandSight::kHidden;
    state.velocity_mmps = state.angularVelocity_radps = {};
    state.tags = 0, state.isAligned = false, state.advice = adviceWithoutBody(frame);
    return;
  }
  const auto middle = project(lens, track.filter.predictedAt(frame.time_ns).offset);
  const auto found = project(lens, measured->cameraFromBody.offset);
  track.surprise_px = middle && found ? std::hypot(middle->x - found->x, middle->y - found->y) : 1e9;
  track.framesSinceCorners = measured->hasCorners ? 0 : track.framesSinceCorners + 1;
  track.alignedTags = measured->isAligned ? measured->tags : 0, track.error = measured->error;
  if (track.isLost())
    track.filter.reset(measured->cameraFromBody, frame.time_ns);
  else
    track.filter.update(measured->cameraFromBody, measured->covariance, frame.time_ns);
  track.hiddenFrames = 0;
  if (measured->isAligned) track.blur_px = measured->blur_px;
  state.sight = HandSight::kTracked, state.time_ns = frame.time_ns;
  state.cameraFromBody = track.filter.cameraFromBody(), state.cameraFromMeasured = measured->cameraFromBody;
  state.velocity_mmps = track.filter.velocity_mmps();
  state.angularVelocity_radps = track.filter.angularVelocity_radps();
  state.tags = measured->tags, state.isAligned = measured->isAligned, state.blur_px = measured->blur_px;
  state.advice = adviceFor(*measured, track, *bounds, lens, frame.exposure_ns);
}

HandTracker::HandTracker(const LensModel& lens, std::vector<TagBody> bodies, PoseMethod method)
    : work_(new Work{lens, std::move(bodies), method, camera::PatternAlignment(lens), {}, {}, {}, {}, {}}) {
  work_->states.resize(work_->bodies.size());
  work_->tracks.resize(work_->bodies.size());
}
HandTracker::~HandTracker() = default;
HandTracker::HandTracker(HandTracker&&) noexcept = default;
HandTracker& HandTracker::operator=(HandTracker&&) noexcept = default;

const std::vector<TrackedHand>& HandTracker::process(const CameraFrame& frame) {
  const bool isWhole = frame.pixels.size() == std::size_t(frame.width) * std::size_t(frame.height);
  if (frame.width != work_->lens.width || frame.height != work_->lens.height || !isWhole ||
      frame.time_ns <= work_->time_ns)
    return work_->states;
  work_->time_ns = frame.time_ns;
  work_->isSearched = false;
  for (std::size_t i = 0; i < work_->bodies.size(); ++i) work_->update(frame, i);
  return work_->states;
}

const std::vector<TrackedHand>& HandTracker::states() const {
  return work_->states;
}
const std::vector<TagBody>& HandTracker::bodies() const {
  return work_->bodies;
}

}  // namespace insonate
