#include "Rigid.h"

#include <insonate/camera/SimulatedCamera.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace insonate {
namespace {

constexpr double kPaper = 1, kInk = 0.06, kSkin = 0.45;  // reflectance relative to white paper
constexpr double kAmbient = 0.45;                        // share of the light that comes from everywhere
const Vec3 kTowardLight = normalized(Vec3{-0.4, -0.7, -0.6});

double shade(Vec3 normal_camera) {
  return kAmbient + (1 - kAmbient) * std::max(0.0, dot(normal_camera, kTowardLight));
}

/// A face of a body as planes and tags, in the body frame.
struct Face {
  Vec3 normal, point;
  double brightness = 0;
  std::vector<const BodyTag*> tags;
  std::vector<const TagPattern*> patterns;
  std::vector<Transform> tagFromBody;
};

double reflectance(const Face& face, Vec3 p) {
  for (std::size_t i = 0; i < face.tags.size(); ++i) {
    const BodyTag& tag = *face.tags[i];
    const Vec3 q = face.tagFromBody[i] * p;
    const double cell = tag.size_mm / kTagCells, half = 0.5 * kTagCellsWithBorder;
    const int column = int(std::floor(q.x / cell + half)), row = int(std::floor(half - q.y / cell));
    if (column < 0 || row < 0 || column >= kTagCellsWithBorder || row >= kTagCellsWithBorder) continue;
    return (*face.patterns[i])[std::size_t(row) * kTagCellsWithBorder + std::size_t(column)] ? kPaper : kInk;
  }
  return kPaper;
}

/// A body at one moment, as seen by rays in the camera frame.
class Moment {
 public:
  Moment(const SimulatedObject& object, const Transform& cameraFromBody)
      : bodyFromCamera_(inverted(cameraFromBody)), eye_(bodyFromCamera_.offset), fingers_(object.fingers) {
    for (std::size_t f = 0; f < object.body.faces.size(); ++f) {
      const std::vector<Vec3> corners = cornersOf(object.body, int(f));
      Face face;
      face.normal = normalized(cross(corners[1] - corners[0], corners[2] - corners[0]));
      face.point = corners[0];
      face.brightness = shade(cameraFromBody.linear * face.normal);
      for (const BodyTag& tag : object.body.tags)
        if (tag.face == int(f)) {
          face.tags.push_back(&tag), face.patterns.push_back(&tagPattern(tag.id));
          face.tagFromBody.push_back(inverted(tag.bodyFromTag));
        }
      faces_.push_back(std::move(face));
    }
  }

  /// Brightness relative to white paper along a ray; no value if the ray meets nothing.
  std::optional<double> along(Vec3 ray_camera) const {
    const Vec3 ray = bodyFromCamera_.linear * ray_camera;
    for (const SimulatedFinger& finger : fingers_) {
      const Vec3 toward = finger.center_body - eye_;
      const double nearest = dot(toward, ray) / dot(ray, ray);
      if (norm(toward - ray * nearest) < finger.radius_mm) return kSkin;
    }
    double in = 0, out = std::numeric_limits<double>::infinity();
    const Face* hit = nullptr;
    for (const Face& face : faces_) {
      const double toward = dot(face.normal, ray), height = dot(face.normal, face.point - eye_);
      if (toward < 0) {
        if (height / toward > in) in = height / toward, hit = &face;
      } else if (toward > 0) {
        out = std::min(out, height / toward);
      } else if (height < 0) {
        return std::nullopt;
      }
    }
    if (!hit || in >= out) return std::nullopt;
    return hit->brightness * reflectance(*hit, eye_ + ray * in);
  }

 private:
  Transform bodyFromCamera_;
  Vec3 eye_;
  std::vector<Face> faces_;
  std::vector<SimulatedFinger> fingers_;
};

/// The pixels that a body and its fingers may cover during the exposure.
FrameBox boxOf(const SimulatedObject& object, const LensModel& lens, const std::vector<Transform>& poses, int margin) {
  double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
  const auto include = [&](Vec3 point) {
    const auto pixel = project(lens, point);
    if (!pixel) return;
    left = std::min(left, pixel->x), right = std::max(right, pixel->x);
    top = std::min(top, pixel->y), bottom = std::max(bottom, pixel->y);
  };
  for (const Transform& pose : poses) {
    for (const Vec3& vertex : object.body.vertices_mm) include(pose * vertex);
    for (const SimulatedFinger& finger : object.fingers)
      for (const double side : {-1.1, 1.1})
        for (int axis = 0; axis < 2; ++axis) {
          Vec3 center = pose * finger.center_body;
          center[axis] += side * finger.radius_mm;
          include(center);
        }
  }
  const int l = std::clamp(int(std::floor(left)) - margin, 0, lens.width);
  const int t = std::clamp(int(std::floor(top)) - margin, 0, lens.height);
  const int r = std::clamp(int(std::ceil(right)) + margin, l, lens.width);
  const int b = std::clamp(int(std::ceil(bottom)) + margin, t, lens.height);
  return {l, t, r - l, b - t};
}

/// Gaussian blur of the rows of an image with width `width`; the result is transposed.
std::vector<float> blurredRows(const std::vector<float>& image, int width, int height, double sigma) {
  const int radius = int(std::ceil(4 * sigma));
  std::vector<float> kernel;
  double sum = 0;
  for (int i = -radius; i <= radius; ++i) {
    kernel.push_back(sigma > 0 ? float(std::exp(-0.5 * i * i / (sigma * sigma))) : 1.F);
    sum += kernel.back();
  }
  for (float& k : kernel) k = float(k / sum);
  std::vector<float> result(image.size()), padded(std::size_t(width) + 2 * std::size_t(radius));
  for (int y = 0; y < height; ++y) {
    for (int x = -radius; x < width + radius; ++x)
      padded[std::size_t(x + radius)] = image[std::size_t(y) * width + std::clamp(x, 0, width - 1)];
    for (int x = 0; x < width; ++x) {
      float value = 0;
      for (std::size_t k = 0; k < kernel.size(); ++k) value += kernel[k] * padded[std::size_t(x) + k];
      result[std::size_t(x) * height + y] = value;
    }
  }
  return result;
}

/// Smooth brightness with rectangles, as of a desk with things on it.
std::vector<float> makeBackground(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(0, 1);
  std::vector<float> image(std::size_t(width) * height);
  const float tilt = uniform(random) - 0.5F, level = 0.35F + 0.2F * uniform(random);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image[std::size_t(y) * width + x] =
          level + 0.2F * tilt * float(x) / float(width) - 0.1F * float(y) / float(height);
  constexpr int kThings = 25;
  for (int i = 0; i < kThings; ++i) {
    const int w = int(float(width) * (0.02F + 0.15F * uniform(random)));
    const int h = int(float(height) * (0.02F + 0.15F * uniform(random)));
    const int left = int(uniform(random) * float(width - w)), top = int(uniform(random) * float(height - h));
    const float gray = 0.08F + 0.7F * uniform(random);
    for (int y = top; y < top + h; ++y)
      for (int x = left; x < left + w; ++x) image[std::size_t(y) * width + x] = gray;
  }
  return image;
}

}  // namespace

SimulatedMotion::SimulatedMotion(const Transform& cameraFromBody, double position_mm, double rotation_deg,
                                 double frequency_Hz, unsigned seed)
    : middle_(cameraFromBody) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (std::size_t axis = 0; axis < waves_.size(); ++axis)
    for (std::size_t i = 0; i < 3; ++i) {
      const double rms = axis < 3 ? position_mm : rotation_deg * std::numbers::pi / 180;
      const double share = 0.2 + 0.4 * double(i) + 0.4 * uniform(random);
      waves_[axis][i] = {rms * std::sqrt(2.0 / 3), 2 * std::numbers::pi * frequency_Hz * share,
                         2 * std::numbers::pi * uniform(random)};
    }
}

Transform SimulatedMotion::at(double time_s) const {
  camera::Motion motion;
  for (std::size_t axis = 0; axis < waves_.size(); ++axis) {
    for (const Wave& wave : waves_[axis])
      motion[int(axis)] += wave.amplitude * std::sin(wave.frequency_radps * time_s + wave.phase);
  }
  return camera::movedBy(middle_, motion);
}

SimulatedCamera::SimulatedCamera(const SimulatedSensor& sensor, unsigned seed)
    : sensor_(sensor), background_(makeBackground(sensor.lens.width, sensor.lens.height, seed)), random_(seed) {
  const LensModel& lens = sensor_.lens;
  rays_.reserve(std::size_t(lens.width + 1) * (lens.height + 1));
  for (int y = 0; y <= lens.height; ++y)
    for (int x = 0; x <= lens.width; ++x) rays_.push_back(rayThrough(lens, {double(x), double(y)}));
}

void SimulatedCamera::renderObject(const SimulatedObject& object, double time_s, std::vector<float>& image) const {
  const LensModel& lens = sensor_.lens;
  const double half_s = 0.5e-3 * sensor_.exposure_ms;
  const Transform first = object.cameraFromBody(time_s - half_s), last = object.cameraFromBody(time_s + half_s);
  double path_px = 0;
  for (const Vec3& vertex : object.body.vertices_mm) {
    const auto a = project(lens, first * vertex), b = project(lens, last * vertex);
    if (a && b) path_px = std::max(path_px, std::hypot(a->x - b->x, a->y - b->y));
  }
  const int times = std::clamp(int(std::ceil(2 * path_px)), 1, 16);
  const int fine = times > 4 ? 4 : 6;
  std::vector<Transform> poses;
  for (int i = 0; i < times; ++i) poses.push_back(object.cameraFromBody(time_s + half_s * ((2.0 * i + 1) / times - 1)));
  const FrameBox box = boxOf(object, lens, poses, int(std::ceil(4 * sensor_.blur_px)) + 1);
  if (box.width <= 0 || box.height <= 0) return;

  const int width = box.width * fine, height = box.height * fine;
  std::vector<float> part(std::size_t(width) * height, 0);
  // Samples of neighboring rows and columns are offset by the golden ratio, so that an edge along a row or a column is
  // sampled as finely as an oblique edge.
  std::vector<double> offsets;
  for (int i = 0; i < std::max(width, height); ++i) offsets.push_back(std::fmod(i * std::numbers::phi, 1));
  std::vector<Moment> moments;
  for (const Transform& pose : poses) moments.emplace_back(object, pose);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double px = box.left + (x + offsets[std::size_t(y)]) / fine;
      const double py = box.top + (y + offsets[std::size_t(x)]) / fine;
      const int ix = std::min(int(px), lens.width - 1), iy = std::min(int(py), lens.height - 1);
      const double fx = px - ix, fy = py - iy;
      const Vec3* corner = &rays_[std::size_t(iy) * (lens.width + 1) + ix];
      const Vec3 ray = (corner[0] * (1 - fx) + corner[1] * fx) * (1 - fy) +
                       (corner[lens.width + 1] * (1 - fx) + corner[lens.width + 2] * fx) * fy;
      const float behind = image[std::size_t(iy) * lens.width + ix];
      double sum = 0;
      for (const Moment& moment : moments) sum += moment.along(ray).value_or(behind);
      part[std::size_t(y) * width + x] = float(sum / times);
    }
  part = blurredRows(blurredRows(part, width, height, sensor_.blur_px * fine), height, width, sensor_.blur_px * fine);
  for (int y = 0; y < box.height; ++y)
    for (int x = 0; x < box.width; ++x) {
      float sum = 0;
      for (int j = 0; j < fine; ++j)
        for (int i = 0; i < fine; ++i)
          sum += part[(std::size_t(y) * fine + std::size_t(j)) * width + std::size_t(x) * fine + std::size_t(i)];
      image[std::size_t(box.top + y) * lens.width + box.left + x] = sum / float(fine * fine);
    }
}

CameraFrame SimulatedCamera::render(const std::vector<SimulatedObject>& objects, double time_s) {
  std::vector<float> image = background_;
  std::vector<const SimulatedObject*> order;
  for (const SimulatedObject& object : objects) order.push_back(&object);
  std::ranges::sort(order, std::greater{},
                    [&](const SimulatedObject* o) { return o->cameraFromBody(time_s).offset.z; });
  for (const SimulatedObject* object : order) renderObject(*object, time_s, image);
  CameraFrame frame;
  frame.width = sensor_.lens.width, frame.height = sensor_.lens.height;
  frame.time_ns = std::int64_t(std::llround(time_s * 1e9));
  frame.exposure_ns = std::int64_t(std::llround(sensor_.exposure_ms * 1e6));
  frame.pixels.reserve(image.size());
  std::normal_distribution<float> normal;
  for (const float value : image) {
    const auto gray = float(value * sensor_.white);
    const auto noise = float(std::sqrt(sensor_.noise * sensor_.noise + sensor_.shotNoise * gray));
    frame.pixels.push_back(std::uint8_t(std::clamp(gray + noise * normal(random_) + 0.5F, 0.F, 255.F)));
  }
  return frame;
}

}  // namespace insonate
