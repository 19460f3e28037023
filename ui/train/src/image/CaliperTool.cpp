#include "CaliperTool.h"

#include <cmath>
#include <utility>

namespace insonate::train {
namespace {

/// A drag shorter than this was meant as a click.
constexpr double kClick_mm = 0.6;

int pointsOf(views::CaliperKind kind) {
  return kind == views::CaliperKind::Distance ? 2 : 3;
}

}  // namespace

void CaliperTool::setKind(std::optional<views::CaliperKind> kind) {
  kind_ = kind;
  fixed_ = 0;
}

void CaliperTool::pressed(views::ImagePoint at) {
  if (!kind_) return;
  if (fixed_ == 0) {
    open_ = {*kind_, {at, at, at}};
    fixed_ = 1;
    return;
  }
  moved(at);
  fix();
}

void CaliperTool::moved(views::ImagePoint at) {
  for (int i = fixed_; fixed_ > 0 && i < 3; ++i) open_.points[i] = at;
}

void CaliperTool::released(views::ImagePoint at) {
  if (fixed_ == 0) return;
  const auto& last = open_.points[fixed_ - 1];
  if (std::hypot(at.lateral_mm - last.lateral_mm, at.axial_mm - last.axial_mm) < kClick_mm) return;
  moved(at);
  fix();
}

void CaliperTool::fix() {
  if (++fixed_ < pointsOf(open_.kind)) return;
  done_.push_back(open_);
  fixed_ = 0;
}

void CaliperTool::clear() {
  setDone({});
}

void CaliperTool::setDone(std::vector<views::Caliper> calipers) {
  done_ = std::move(calipers);
  fixed_ = 0;
}

std::vector<views::Caliper> CaliperTool::calipers() const {
  auto all = done_;
  if (fixed_ > 0) all.push_back(open_);
  return all;
}

}  // namespace insonate::train
