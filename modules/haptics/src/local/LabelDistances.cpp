#include "local/LabelDistances.h"

#include <algorithm>
#include <cmath>

namespace insonate::haptics {
namespace {

constexpr float kFar_mm2 = 1e9F, kMost_mm = 300;

/// Lower envelope of parabolas along one line, in place: Felzenszwalb and Huttenlocher, Distance transforms of sampled
/// functions, Theory of Computing 2012;8:415-428.
struct LineTransform {
  std::vector<float> values;
  std::vector<int> vertex;
  std::vector<double> border;

  explicit LineTransform(int most) : values(most), vertex(most), border(most + 1) {}

  void run(float* first, std::size_t stride, int count, double spacing_mm) {
    const double square = spacing_mm * spacing_mm;
    for (int i = 0; i < count; ++i) values[i] = first[i * stride];
    int top = 0;
    vertex[0] = 0;
    border[0] = -1e30, border[1] = 1e30;
    for (int q = 1; q < count; ++q) {
      double cut = 0;
      for (;;) {
        const int v = vertex[top];
        cut = ((double(values[q]) - values[v]) / square + double(q) * q - double(v) * v) / (2.0 * (q - v));
        if (cut > border[top] || top == 0) break;
        --top;
      }
      if (cut <= border[top]) {
        vertex[0] = q;
      } else {
        vertex[++top] = q;
        border[top] = cut;
      }
      border[top + 1] = 1e30;
    }
    for (int q = 0, k = 0; q < count; ++q) {
      while (border[k + 1] < q) ++k;
      const double away = q - vertex[k];
      first[q * stride] = static_cast<float>(away * away * square + values[vertex[k]]);
    }
  }
};

/// Calls `line(first, stride, count, axis)` for every line of voxels along each axis in turn.
template <class Line>
void alongAxes(const VolumeGeometry& g, std::vector<float>& field, const Line& line) {
  const std::array<std::size_t, 3> stride{1, std::size_t(g.size[0]), std::size_t(g.size[0]) * g.size[1]};
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int b = 0; b < g.size[v]; ++b)
      for (int a = 0; a < g.size[u]; ++a)
        line(field.data() + a * stride[u] + b * stride[v], stride[axis], g.size[axis], axis);
  }
}

void squaredDistances(const VolumeGeometry& g, std::vector<float>& field) {
  LineTransform transform(*std::max_element(g.size.begin(), g.size.end()));
  alongAxes(g, field, [&](float* first, std::size_t stride, int count, int axis) {
    transform.run(first, stride, count, g.spacing_mm[axis]);
  });
}

/// Filters by a quarter, a half, a quarter along each axis, which smooths the voxel steps of a label map's surface.
void smooth(const VolumeGeometry& g, std::vector<float>& field) {
  alongAxes(g, field, [](float* first, std::size_t stride, int count, int) {
    float before = first[0];
    for (int i = 0; i < count; ++i) {
      const float here = first[i * stride];
      const float after = first[std::min(i + 1, count - 1) * stride];
      first[i * stride] = 0.25F * before + 0.5F * here + 0.25F * after;
      before = here;
    }
  });
}

}  // namespace

std::vector<float> signedDistances(const LabelMap& labels, const std::function<bool(std::uint8_t)>& inside) {
  const VolumeGeometry& g = labels.geometry;
  const auto count = static_cast<std::size_t>(std::count_if(labels.voxels.begin(), labels.voxels.end(), inside));
  // Most maps lack some structures, and most regions of a neck are entirely inside it.
  if (count == 0 || count == labels.voxels.size())
    return std::vector<float>(labels.voxels.size(), count == 0 ? kMost_mm : -kMost_mm);
  std::vector<float> toInside(labels.voxels.size()), toOutside(labels.voxels.size());
  for (std::size_t i = 0; i < labels.voxels.size(); ++i) {
    const bool in = inside(labels.voxels[i]);
    toInside[i] = in ? 0 : kFar_mm2;
    toOutside[i] = in ? kFar_mm2 : 0;
  }
  squaredDistances(g, toInside);
  squaredDistances(g, toOutside);
  // Voxel centers on either side of a surface are one voxel apart; the surface is halfway between them.
  const auto half = static_cast<float>(0.5 * std::min({g.spacing_mm.x, g.spacing_mm.y, g.spacing_mm.z}));
  for (std::size_t i = 0; i < toInside.size(); ++i) {
    const float out = std::sqrt(toInside[i]), in = std::sqrt(toOutside[i]);
    toInside[i] = std::clamp(out > 0 ? out - half : half - in, -kMost_mm, kMost_mm);
  }
  smooth(g, toInside);
  return toInside;
}

}  // namespace insonate::haptics
