#include "FovModel.h"

#include <algorithm>
#include <cmath>

namespace insonate::fit {
namespace {

constexpr double kPoint_px = 6;  // a face with a smaller radius counts as a point

}  // namespace

Beyond::Beyond(const FovModel& model)
    : model_(model),
      cosTurn_(std::cos(model.turn)),
      sinTurn_(std::sin(model.turn)),
      cosHalf_(std::cos(model.half)),
      sinHalf_(std::sin(model.half)) {}

std::array<double, kEdges> Beyond::operator()(PixelPoint p) const {
  const double dx = p.x - model_.x, dy = p.y - model_.y;
  const double u = cosTurn_ * dx - sinTurn_ * dy, v = sinTurn_ * dx + cosTurn_ * dy;
  if (!model_.fan) return {-u - model_.half, u - model_.half, model_.inner - v, v - model_.outer};
  const double radius = std::sqrt(u * u + v * v);
  // Behind the apex, the nearest point of a side is the apex.
  const auto side = [&](double across) {
    if (across * sinHalf_ + v * cosHalf_ < 0) return across >= 0 ? radius : -radius;
    return across * cosHalf_ - v * sinHalf_;
  };
  return {side(-u), side(u), model_.inner - radius, radius - model_.outer};
}

bool Beyond::inside(PixelPoint p) const {
  const auto by = (*this)(p);
  return *std::max_element(by.begin(), by.end()) <= 0;
}

std::array<double, kEdges> FovModel::beyond(PixelPoint p) const {
  return Beyond(*this)(p);
}

PixelPoint FovModel::at(double across, double down) const {
  const double reach = inner + down * (outer - inner);
  const double u = fan ? reach * std::sin(across * half) : across * half;
  const double v = fan ? reach * std::cos(across * half) : reach;
  const double c = std::cos(turn), s = std::sin(turn);
  return {x + c * u + s * v, y - s * u + c * v};
}

double FovModel::area() const {
  return fan ? half * (outer * outer - inner * inner) : 2 * half * (outer - inner);
}

std::vector<EdgeSample> edgeSamples(const FovModel& model, double step_px) {
  std::vector<EdgeSample> samples;
  const double c = std::cos(model.turn), s = std::sin(model.turn);
  const auto turned = [&](double u, double v) { return PixelPoint{c * u + s * v, -s * u + c * v}; };
  const double length = model.outer - model.inner;
  for (const double side : {-1.0, 1.0}) {
    const double angle = model.fan ? side * model.half : 0;
    const PixelPoint outward = turned(side * std::cos(angle), -side * std::sin(angle));
    const int count = std::max(2, int(length / step_px));
    for (int k = 0; k < count; ++k)
      samples.push_back({model.at(side, (k + 0.5) / count), outward, side < 0 ? kLeft : kRight});
  }
  for (const Edge edge : {kFace, kDeep}) {
    const double radius = edge == kFace ? model.inner : model.outer;
    if (model.fan && radius < kPoint_px) continue;
    const double sign = edge == kFace ? -1 : 1;
    const int count = std::max(3, int(2 * model.half * (model.fan ? radius : 1) / step_px));
    for (int k = 0; k < count; ++k) {
      const double across = -1 + (k + 0.5) * 2 / count, angle = model.fan ? across * model.half : 0;
      samples.push_back(
          {model.at(across, edge == kFace ? 0 : 1), turned(sign * std::sin(angle), sign * std::cos(angle)), edge});
    }
  }
  return samples;
}

int parameters(const FovModel& model) {
  return model.fan ? 6 : 5;
}

double& parameter(FovModel& model, int index) {
  const std::array all{&model.x, &model.y, &model.turn, &model.half, &model.outer, &model.inner};
  return *all[std::size_t(index)];
}

}  // namespace insonate::fit
