#include "LensDerivative.h"
#include "Rigid.h"

#include <insonate/camera/BodyPose.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace insonate {
namespace {

using camera::Matrix;
using camera::Motion;
using Equation = Matrix<6, 6>;

constexpr double kCornerNoise_px = 0.15;  // corners of AprilTag 3 in sharp images
constexpr double kHuber_px = 1;
constexpr double kOutOfView_px = 1e4;

/// A detected tag of the body.
struct SeenTag {
  const BodyTag* tag = nullptr;
  std::array<Vec3, 4> corners_body;
  std::array<FramePoint, 4> corners_px;
  double limit_px = 0;  ///< largest error with which the tag counts as fitting
  std::size_t index = 0;
};

struct Fit {
  Transform cameraFromBody;
  double cost = std::numeric_limits<double>::infinity();  ///< mean square error of a corner, px^2
  Equation information;                                   ///< sum of J^T J, px^-2
};

std::vector<SeenTag> tagsOf(const TagBody& body, const std::vector<TagDetection>& detections) {
  std::vector<SeenTag> seen;
  for (const TagDetection& detection : detections) {
    const auto tag = std::ranges::find(body.tags, detection.id, &BodyTag::id);
    if (tag == body.tags.end()) continue;
    SeenTag s{&*tag, cornersOf(*tag), detection.corners, 0, seen.size()};
    for (Vec3& corner : s.corners_body) corner = tag->bodyFromTag * corner;
    double around_px = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const FramePoint &a = s.corners_px[i], &b = s.corners_px[(i + 1) % 4];
      around_px += std::hypot(a.x - b.x, a.y - b.y);
    }
    constexpr double kBase_px = 1, kShareOfSide = 0.05;
    s.limit_px = kBase_px + kShareOfSide * around_px / 4;
    seen.push_back(s);
  }
  return seen;
}

/// Root mean square error of the tag's corners, px; infinite if the tag faces away or is behind the camera.
double errorOf(const SeenTag& seen, const LensModel& lens, const Transform& cameraFromBody) {
  const Transform cameraFromTag = cameraFromBody * seen.tag->bodyFromTag;
  if (dot(cameraFromTag.linear.column[2], cameraFromTag.offset) >= 0) return std::numeric_limits<double>::infinity();
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto pixel = project(lens, cameraFromBody * seen.corners_body[i]);
    if (!pixel) return std::numeric_limits<double>::infinity();
    const double dx = pixel->x - seen.corners_px[i].x, dy = pixel->y - seen.corners_px[i].y;
    sum += dx * dx + dy * dy;
  }
  return std::sqrt(sum / 4);
}

/// The normal equations of all corners at a pose, with Huber's weights.
struct PoseEquations {
  Equation matrix, information;
  Motion right;
  double robustCost = 0, squares = 0;
};

/// Derivative of a coordinate by the body's motion: `by_point` times (v + w x lever).
Motion rowOf(Vec3 by_point, Vec3 lever) {
  const Vec3 w = cross(lever, by_point);
  return {{by_point.x, by_point.y, by_point.z, w.x, w.y, w.z}};
}

void add(PoseEquations& e, const Motion& row, double rest, double weight) {
  for (int i = 0; i < 6; ++i) {
    e.right[i] += weight * row[i] * rest;
    for (int j = 0; j < 6; ++j) e.information(i, j) += row[i] * row[j], e.matrix(i, j) += weight * row[i] * row[j];
  }
}

PoseEquations poseEquationsAt(const Transform& pose, const LensModel& lens, const std::vector<SeenTag>& tags) {
  PoseEquations e;
  for (const SeenTag& seen : tags)
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 lever = pose.linear * seen.corners_body[i];
      const auto projected = camera::projectWithDerivative(lens, lever + pose.offset);
      if (!projected) {
        e.robustCost += kOutOfView_px, e.squares += kOutOfView_px;
        continue;
      }
      const double dx = seen.corners_px[i].x - projected->pixel.x, dy = seen.corners_px[i].y - projected->pixel.y;
      const double size = std::hypot(dx, dy), weight = size > kHuber_px ? kHuber_px / size : 1;
      add(e, rowOf(projected->dx, lever), dx, weight);
      add(e, rowOf(projected->dy, lever), dy, weight);
      e.robustCost += size > kHuber_px ? 2 * kHuber_px * size - kHuber_px * kHuber_px : size * size;
      e.squares += size * size;
    }
  return e;
}

Fit refined(Transform pose, const LensModel& lens, const std::vector<SeenTag>& tags) {
  constexpr int kIterations = 30;
  constexpr double kSmallStep = 1e-7;
  double damping = 1e-4;
  PoseEquations now = poseEquationsAt(pose, lens, tags);
  for (int i = 0; i < kIterations; ++i) {
    Equation matrix = now.matrix;
    for (int d = 0; d < 6; ++d) matrix(d, d) *= 1 + damping;
    const Motion step = camera::solved(matrix, now.right);
    const double length = norm(camera::shiftOf(step)) + norm(camera::turnOf(step));
    if (!std::isfinite(length)) break;
    const Transform moved = camera::movedBy(pose, step);
    const PoseEquations next = poseEquationsAt(moved, lens, tags);
    if (next.robustCost < now.robustCost) {
      pose = moved, now = next;
      damping = std::max(1e-9, damping / 10);
      if (length < kSmallStep) break;
    } else {
      damping *= 10;
      if (damping > 1e6 || length < kSmallStep) break;
    }
  }
  return {pose, now.squares / double(4 * tags.size()), now.information};
}

/// Pose of a tag from the homography of its four corners; no value if the corners are degenerate.
std::optional<Transform> poseFromHomography(const SeenTag& seen, const LensModel& lens) {
  Matrix<8, 8> a;
  Matrix<8, 1> b;
  const auto corners = cornersOf(*seen.tag);
  const double half_mm = seen.tag->size_mm / 2;
  for (int i = 0; i < 4; ++i) {
    const Vec3 ray = rayThrough(lens, seen.corners_px[std::size_t(i)]);
    const double X = corners[std::size_t(i)].x / half_mm, Y = corners[std::size_t(i)].y / half_mm;
    const double first[8] = {X, Y, 1, 0, 0, 0, -ray.x * X, -ray.x * Y};
    const double second[8] = {0, 0, 0, X, Y, 1, -ray.y * X, -ray.y * Y};
    for (int j = 0; j < 8; ++j) a(2 * i, j) = first[j], a(2 * i + 1, j) = second[j];
    b[2 * i] = ray.x, b[2 * i + 1] = ray.y;
  }
  const auto t = camera::transposed(a);
  const Matrix<8, 1> h = camera::solved(t * a, t * b);
  const Vec3 h1{h[0], h[3], h[6]}, h2{h[1], h[4], h[7]}, h3{h[2], h[5], 1};
  const double scale = 2 * half_mm / (norm(h1) + norm(h2));
  if (!std::isfinite(scale)) return std::nullopt;
  // The two axes are made perpendicular by turning both by the same angle.
  const Vec3 sum = normalized(normalized(h1) + normalized(h2)), across = normalized(normalized(h1) - normalized(h2));
  const Vec3 x = (sum + across) * std::sqrt(0.5), y = (sum - across) * std::sqrt(0.5);
  if (!isFinite(x) || !isFinite(y)) return std::nullopt;
  return Transform{camera::orthonormal({{x, y, cross(x, y)}}), h3 * scale};
}

/// The second pose that explains a small planar tag nearly as well: the tag's normal mirrored at the line of sight
/// (Schweighofer and Pinz 2006).
Transform mirrored(const Transform& cameraFromTag) {
  const Vec3 sight = normalized(cameraFromTag.offset), normal = cameraFromTag.linear.column[2];
  const Vec3 other = sight * (2 * dot(sight, normal)) - normal;
  const Vec3 axis = cross(normal, other);
  const double sine = norm(axis), angle = std::atan2(sine, dot(normal, other));
  if (!(sine > 1e-9)) return cameraFromTag;
  return {camera::orthonormal(camera::rotationBy(axis * (angle / sine)) * cameraFromTag.linear), cameraFromTag.offset};
}

/// Angle between two poses, rad, plus their distance relative to the distance from the camera.
double poseDifference(const Transform& a, const Transform& b) {
  return norm(camera::rotationVector(a.linear * transposed(b.linear))) + norm(a.offset - b.offset) / norm(b.offset);
}

/// Sum over the tags of their relative error, each 1 at most, so that wrong tags cannot outvote the others.
double score(const Transform& pose, const LensModel& lens, const std::vector<SeenTag>& tags,
             const std::optional<Transform>& expected) {
  double sum = 0;
  for (const SeenTag& seen : tags) {
    const double relative = errorOf(seen, lens, pose) / (3 * seen.limit_px);
    sum += std::min(1.0, relative * relative);
  }
  return sum + (expected ? 0.5 * std::min(1.0, poseDifference(pose, *expected)) : 0);
}

std::vector<Transform> candidatesOf(const std::vector<SeenTag>& tags, const LensModel& lens) {
  std::vector<Transform> candidates;
  for (const SeenTag& seen : tags) {
    const auto cameraFromTag = poseFromHomography(seen, lens);
    if (!cameraFromTag) continue;
    const Transform tagFromBody = inverted(seen.tag->bodyFromTag);
    const std::vector<SeenTag> alone{seen};
    for (const Transform& pose : {*cameraFromTag, mirrored(*cameraFromTag)})
      candidates.push_back(refined(pose * tagFromBody, lens, alone).cameraFromBody);
  }
  return candidates;
}

std::vector<SeenTag> fitting(const Transform& pose, const LensModel& lens, const std::vector<SeenTag>& tags) {
  std::vector<SeenTag> good;
  for (const SeenTag& seen : tags)
    if (errorOf(seen, lens, pose) <= seen.limit_px) good.push_back(seen);
  return good;
}

std::vector<int> wrongTags(const std::vector<SeenTag>& used, const std::vector<SeenTag>& all) {
  std::vector<int> wrong;
  for (const SeenTag& seen : all)
    if (std::ranges::find(used, seen.index, &SeenTag::index) == used.end()) wrong.push_back(seen.tag->id);
  return wrong;
}

BodyPose resultOf(const Fit& fit, const std::vector<SeenTag>& used, const std::vector<SeenTag>& all) {
  BodyPose pose;
  pose.cameraFromBody = fit.cameraFromBody;
  pose.error_px = std::sqrt(fit.cost), pose.tags = int(used.size());
  const double noise_px = std::max(kCornerNoise_px, pose.error_px);
  pose.covariance = (camera::inverted(fit.information) * (noise_px * noise_px)).values;
  pose.wrongTags = wrongTags(used, all);
  return pose;
}

/// Chooses among the poses of a single tag.
std::optional<BodyPose> poseOfOneTag(const std::vector<SeenTag>& tags, const LensModel& lens,
                                     const std::optional<Transform>& expected) {
  std::vector<Fit> fits;
  for (const Transform& candidate : candidatesOf(tags, lens)) fits.push_back(refined(candidate, lens, tags));
  if (expected) fits.push_back(refined(*expected, lens, tags));
  std::erase_if(fits, [&](const Fit& fit) { return fitting(fit.cameraFromBody, lens, tags).empty(); });
  if (fits.empty()) return std::nullopt;
  std::ranges::sort(fits, {}, &Fit::cost);
  // A wrong pose has a mean square error that is larger by the tag's perspective; below the noise it proves nothing.
  constexpr double kSure = 4;
  const double sure = kSure * std::max(fits.front().cost, 2 * kCornerNoise_px * kCornerNoise_px);
  std::erase_if(fits, [&](const Fit& fit) { return fit.cost > sure; });
  constexpr double kSame = 0.05;
  const bool isAmbiguous = std::ranges::any_of(
      fits, [&](const Fit& fit) { return poseDifference(fit.cameraFromBody, fits.front().cameraFromBody) > kSame; });
  const auto nearest = [&](const Fit& fit) {
    return expected ? poseDifference(fit.cameraFromBody, *expected) : fit.cost;
  };
  BodyPose pose = resultOf(*std::ranges::min_element(fits, {}, nearest), tags, tags);
  pose.isAmbiguous = isAmbiguous;
  return pose;
}

}  // namespace

std::optional<BodyPose> estimatePose(const TagBody& body, const LensModel& lens,
                                     const std::vector<TagDetection>& detections,
                                     const std::optional<Transform>& expected) {
  const std::vector<SeenTag> all = tagsOf(body, detections);
  if (all.empty()) return std::nullopt;
  if (all.size() == 1) return poseOfOneTag(all, lens, expected);
  if (expected) {
    const Fit fit = refined(*expected, lens, all);
    if (fitting(fit.cameraFromBody, lens, all).size() == all.size()) return resultOf(fit, all, all);
  }
  std::vector<Transform> candidates = candidatesOf(all, lens);
  if (expected) candidates.push_back(*expected);
  if (candidates.empty()) return std::nullopt;
  const auto scoreOf = [&](const Transform& pose) { return score(pose, lens, all, expected); };
  Transform pose = *std::ranges::min_element(candidates, {}, scoreOf);
  // The pose of one tag is turned by its noise, so that tags on other faces first fit only roughly.
  for (const double slack : {4.0, 2.0, 1.0}) {
    std::vector<SeenTag> good;
    for (const SeenTag& seen : all)
      if (errorOf(seen, lens, pose) <= slack * seen.limit_px) good.push_back(seen);
    if (good.empty()) return std::nullopt;
    pose = refined(pose, lens, good).cameraFromBody;
  }
  const std::vector<SeenTag> good = fitting(pose, lens, all);
  if (good.empty()) return std::nullopt;
  if (good.size() == 1) {
    auto alone = poseOfOneTag(good, lens, expected ? *expected : pose);
    if (!alone) return std::nullopt;
    alone->wrongTags = wrongTags(good, all);
    alone->isAmbiguous = true;
    return alone;
  }
  return resultOf(refined(pose, lens, good), good, all);
}

}  // namespace insonate
