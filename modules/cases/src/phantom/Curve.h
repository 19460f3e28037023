#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <vector>

namespace insonate::phantom {

/// N quantities given at knots and interpolated by cubic Hermite pieces with finite-difference tangents (an uneven
/// Catmull-Rom spline); constant beyond the ends.
template <std::size_t N>
class Curve {
 public:
  struct Knot {
    double at = 0;
    std::array<double, N> value{};
  };

  Curve(std::initializer_list<Knot> knots) : Curve(std::vector<Knot>(knots)) {}
  /// Makes a curve through at least one knot. The knots can be in any order, no two at the same position.
  explicit Curve(std::vector<Knot> knots) : knots_(std::move(knots)) {
    std::sort(knots_.begin(), knots_.end(), [](const Knot& a, const Knot& b) { return a.at < b.at; });
  }

  std::array<double, N> operator()(double at) const {
    if (at <= knots_.front().at) return knots_.front().value;
    if (at >= knots_.back().at) return knots_.back().value;
    std::size_t k = 0;
    while (knots_[k + 1].at < at) ++k;
    const double h = knots_[k + 1].at - knots_[k].at, t = (at - knots_[k].at) / h;
    const double h00 = (1 + 2 * t) * (1 - t) * (1 - t), h10 = t * (1 - t) * (1 - t) * h;
    const double h01 = t * t * (3 - 2 * t), h11 = t * t * (t - 1) * h;
    std::array<double, N> result{};
    for (std::size_t n = 0; n < N; ++n)
      result[n] = h00 * knots_[k].value[n] + h10 * slope(k, n) + h01 * knots_[k + 1].value[n] + h11 * slope(k + 1, n);
    return result;
  }

  double first() const { return knots_.front().at; }
  double last() const { return knots_.back().at; }
  std::vector<Knot>& knots() { return knots_; }

 private:
  double slope(std::size_t k, std::size_t n) const {
    const std::size_t a = k > 0 ? k - 1 : k, b = std::min(k + 1, knots_.size() - 1);
    return a == b ? 0 : (knots_[b].value[n] - knots_[a].value[n]) / (knots_[b].at - knots_[a].at);
  }

  std::vector<Knot> knots_;
};

}  // namespace insonate::phantom
