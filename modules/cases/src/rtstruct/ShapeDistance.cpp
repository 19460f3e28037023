#include "ShapeDistance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace insonate {
namespace {

constexpr float kFarAway_mm2 = 1e9F;

/// Squared distances along one line: lower envelope of parabolas, Felzenszwalb and Huttenlocher, Distance transforms of
/// sampled functions, Theory of Computing 2012;8:415-428.
class Envelope {
 public:
  explicit Envelope(std::size_t most) : values_(most), vertex_(most), border_(most + 1) {}

  void apply(float* first, std::size_t stride, int count, double spacing_mm) {
    const double square = spacing_mm * spacing_mm;
    for (int q = 0; q < count; ++q) values_[q] = first[q * stride];
    int top = 0;
    vertex_[0] = 0;
    border_[0] = -1e30;
    border_[1] = 1e30;
    for (int q = 1; q < count; ++q) {
      double cut = crossing(q, vertex_[top], square);
      while (top > 0 && cut <= border_[top]) cut = crossing(q, vertex_[--top], square);
      border_[++top] = cut;
      vertex_[top] = q;
      border_[top + 1] = 1e30;
    }
    for (int q = 0, n = 0; q < count; ++q) {
      while (border_[n + 1] < q) ++n;
      const double away = q - vertex_[n];
      first[q * stride] = static_cast<float>(away * away * square + values_[vertex_[n]]);
    }
  }

 private:
  double crossing(int q, int v, double square) const {
    return ((double{values_[q]} - values_[v]) / square + double(q) * q - double(v) * v) / (2.0 * (q - v));
  }

  std::vector<float> values_;
  std::vector<int> vertex_;
  std::vector<double> border_;
};

/// Squared distance to the nearest pixel that has this value.
std::vector<float> squaresTo(const SliceMask& mask, std::uint8_t value, double betweenColumns_mm,
                             double betweenRows_mm) {
  std::vector<float> field(mask.inside.size());
  std::ranges::transform(mask.inside, field.begin(),
                         [value](std::uint8_t pixel) { return pixel == value ? 0 : kFarAway_mm2; });
  Envelope line(static_cast<std::size_t>(std::max(mask.columns, mask.rows)));
  const auto stride = static_cast<std::size_t>(mask.columns);
  for (int j = 0; j < mask.rows; ++j) line.apply(&field[j * stride], 1, mask.columns, betweenColumns_mm);
  for (int i = 0; i < mask.columns; ++i) line.apply(&field[i], stride, mask.rows, betweenRows_mm);
  return field;
}

}  // namespace

std::vector<float> shapeDistances(const SliceMask& mask, double betweenColumns_mm, double betweenRows_mm) {
  const std::vector<float> toOutside = squaresTo(mask, 0, betweenColumns_mm, betweenRows_mm);
  std::vector<float> distances = squaresTo(mask, 1, betweenColumns_mm, betweenRows_mm);
  for (std::size_t p = 0; p < distances.size(); ++p)
    distances[p] = mask.inside[p] ? std::sqrt(toOutside[p]) : -std::sqrt(distances[p]);
  return distances;
}

}  // namespace insonate
