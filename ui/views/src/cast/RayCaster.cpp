#include "RayCaster.h"

#include "../scene/SceneLights.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace insonate::views {
namespace {

/// Transmission below which a ray ends.
constexpr float kOpaque = 0.01F;
/// Opacity of a step below which shading is omitted.
constexpr float kShadedFrom = 0.004F;
/// Change in HU for each voxel below which there is no surface to shade.
constexpr double kFlat_HU = 4;
constexpr double kAmbient = 0.35, kDiffuse = 0.85, kSpecular = 0.1;

}  // namespace

bool CastView::operator==(const CastView& other) const {
  const auto same = [](const auto& a, const auto& b) {
    return a.has_value() == b.has_value() && (!a || (a->point_mm == b->point_mm && a->normal == b->normal));
  };
  return patientFromSeen == other.patientFromSeen && same(clipping, other.clipping) && width == other.width &&
         height == other.height && depth == other.depth;
}

/// A ray in the grid's indices: from + t * way for t from first to last; one step is `step` of t.
struct RayCaster::Ray {
  float from[3], way[3];
  float first, last, step;
};

RayCaster::RayCaster(const CastTask& task)
    : task_(task),
      grid_(task.coarse ? task.look->volume->coarse : task.look->volume->fine),
      level_(task.coarse ? task.look->coarse : task.look->fine),
      normal_(transposed(grid_.indexFromPatient.linear)) {
  const auto& axes = task.view.patientFromCamera;
  for (std::size_t k = 0; k < light_.size(); ++k)
    light_[k] = normalized(axes[0] * kSceneLights[k].x + axes[1] * kSceneLights[k].y + axes[2] * kSceneLights[k].z);
}

Vec3 RayCaster::patient(double x, double y, double z) const {
  const auto& m = task_.view.patientFromSeen;
  const double w = m[12] * x + m[13] * y + m[14] * z + m[15];
  return Vec3{m[0] * x + m[1] * y + m[2] * z + m[3], m[4] * x + m[5] * y + m[6] * z + m[7],
              m[8] * x + m[9] * y + m[10] * z + m[11]} /
         w;
}

std::optional<RayCaster::Ray> RayCaster::ray(double across, double up, float depth) const {
  const Vec3 near_mm = patient(across, up, -1), far_mm = patient(across, up, 1);
  const Vec3 from = grid_.indexFromPatient * near_mm, way = grid_.indexFromPatient * far_mm - from;
  const double length_mm = norm(far_mm - near_mm);
  double first = 0, last = 1;
  if (depth < 1) last = norm(patient(across, up, 2 * double(depth) - 1) - near_mm) / length_mm;
  const auto keep = [&](double distance, double rate) {  // range where distance + t * rate is not negative
    if (std::abs(rate) < 1e-12) return void(last = distance < 0 ? -1 : last);
    if (rate > 0)
      first = std::max(first, -distance / rate);
    else
      last = std::min(last, -distance / rate);
  };
  for (int axis = 0; axis < 3; ++axis) {
    keep(from[axis] + 0.5, way[axis]);
    keep(grid_.size[std::size_t(axis)] - 0.5 - from[axis], -way[axis]);
  }
  if (const auto& plane = task_.view.clipping)
    keep(dot(near_mm - plane->point_mm, plane->normal), dot(far_mm - near_mm, plane->normal));
  if (!(first < last)) return std::nullopt;
  Ray ray;
  for (int axis = 0; axis < 3; ++axis) ray.from[axis] = float(from[axis]), ray.way[axis] = float(way[axis]);
  ray.step = float(level_.step_mm / length_mm);
  ray.first = float(first), ray.last = float(last);
  return ray;
}

/// Trilinear; outside, the nearest edge voxel.
inline float RayCaster::sample(float x, float y, float z) const {
  const auto clamped = [](float at, int size) { return std::min(std::max(at, 0.F), float(size - 1)); };
  x = clamped(x, grid_.size[0]), y = clamped(y, grid_.size[1]), z = clamped(z, grid_.size[2]);
  const int i = int(x), j = int(y), k = int(z);
  const std::ptrdiff_t row = grid_.size[0], slice = row * grid_.size[1];
  const std::int16_t* at = grid_.voxels + k * slice + j * row + i;
  const std::ptrdiff_t right = i + 1 < grid_.size[0], below = j + 1 < grid_.size[1] ? row : 0,
                       above = k + 1 < grid_.size[2] ? slice : 0;
  x -= float(i), y -= float(j), z -= float(k);
  const auto mix = [](float a, float b, float share) { return a + (b - a) * share; };
  const auto line = [&](const std::int16_t* p) { return mix(p[0], p[right], x); };
  const auto plane = [&](const std::int16_t* p) { return mix(line(p), line(p + below), y); };
  return mix(plane(at), plane(at + above), z);
}

/// Lights both sides of a surface, as the lights of the scene do.
std::array<float, 3> RayCaster::shade(const CastLook::Entry& entry, const float at[3]) const {
  const Vec3 gradient{sample(at[0] + 1, at[1], at[2]) - sample(at[0] - 1, at[1], at[2]),
                      sample(at[0], at[1] + 1, at[2]) - sample(at[0], at[1] - 1, at[2]),
                      sample(at[0], at[1], at[2] + 1) - sample(at[0], at[1], at[2] - 1)};
  float matt = float(kAmbient + kDiffuse * 0.5), shine = 0;
  if (norm(gradient) > kFlat_HU) {
    const Vec3 normal = normalized(normal_ * gradient);
    const Vec3 toward = task_.view.patientFromCamera[2];
    matt = float(kAmbient);
    for (std::size_t k = 0; k < light_.size(); ++k) {
      const double slant = dot(normal, light_[k]);
      matt += float(kDiffuse * kSceneLights[k].intensity * std::abs(slant));
      const double mirrored = 2 * slant * dot(normal, toward) - dot(light_[k], toward);
      const double square = mirrored * mirrored, fourth = square * square;
      shine += float(kSpecular * kSceneLights[k].intensity * fourth * fourth);
    }
  }
  return {entry.red * matt + shine, entry.green * matt + shine, entry.blue * matt + shine};
}

std::array<float, 4> RayCaster::cast(const Ray& ray) const {
  float red = 0, green = 0, blue = 0, through = 1;
  // Steps are counted from the eye, so that samples do not depend on where a ray enters.
  float t = std::ceil(ray.first / ray.step) * ray.step;
  std::size_t known = std::size_t(-1);
  while (t < ray.last) {
    float at[3];
    int block[3];
    for (int axis = 0; axis < 3; ++axis) {
      at[axis] = ray.from[axis] + t * ray.way[axis];
      block[axis] = std::clamp(int(at[axis]), 0, grid_.size[std::size_t(axis)] - 1) >> CastGrid::kShift;
    }
    const std::size_t here = grid_.block(block[0], block[1], block[2]);
    if (here != known) {
      if (!level_.seen[here]) {
        float leaves = ray.last;
        for (int axis = 0; axis < 3; ++axis) {
          const float way = ray.way[axis];
          if (way == 0) continue;
          const bool first = block[axis] == 0, final = block[axis] + 1 == grid_.blocks[std::size_t(axis)];
          if (way > 0 ? final : first) continue;
          const int border = (block[axis] + (way > 0)) << CastGrid::kShift;
          leaves = std::min(leaves, (float(border) - ray.from[axis]) / way);
        }
        t += std::max(1.F, std::ceil((leaves - t) / ray.step)) * ray.step;
        continue;
      }
      known = here;
    }
    const float hu = sample(at[0], at[1], at[2]);
    const CastLook::Entry& entry = level_.entries[std::size_t(CastLook::entryOf(int(std::floor(hu + 0.5F))))];
    if (entry.opacity > 0) {
      const float share = through * entry.opacity;
      std::array<float, 3> color{entry.red, entry.green, entry.blue};
      if (share > kShadedFrom) color = shade(entry, at);
      red += share * color[0], green += share * color[1], blue += share * color[2];
      through *= 1 - entry.opacity;
      if (through < kOpaque) {
        through = 0;
        break;
      }
    }
    t += ray.step;
  }
  return {red, green, blue, 1 - through};
}

void RayCaster::castRow(int row, std::uint8_t* rgba) const {
  const CastView& view = task_.view;
  const double up = (row + 0.5) / task_.up;
  const float* depths = view.depth.data() + std::size_t(up * view.height) * view.width;
  for (int column = 0; column < task_.across; ++column, rgba += 4) {
    const double across = (column + 0.5) / task_.across;
    const auto one = ray(2 * across - 1, 2 * up - 1, depths[std::size_t(across * view.width)]);
    const std::array<float, 4> seen = one ? cast(*one) : std::array<float, 4>{};
    for (std::size_t k = 0; k < 4; ++k)
      rgba[k] = std::uint8_t(std::clamp(seen[k], 0.F, std::max(seen[3], 0.F)) * 255 + 0.5F);
  }
}

void castAll(const CastTask& task, std::vector<std::uint8_t>& rgba) {
  rgba.resize(std::size_t(4) * task.across * task.up);
  const RayCaster caster(task);
  tbb::parallel_for(0, task.up,
                    [&](int row) { caster.castRow(row, rgba.data() + std::size_t(4) * row * task.across); });
}

}  // namespace insonate::views
