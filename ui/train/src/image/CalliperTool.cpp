#include "CalliperTool.h"

#include <cmath>
#include <utility>

namespace insonate::train {
namespace {

/// A drag shorter than this was meant as a click.
constexpr double kClick_mm = 0.6;

int pointsOf(views::CalliperKind kind) {
  return kind == views::CalliperKind::Distance ? 2 : 3;
}

}  // namespace

void CalliperTool::setKind(std::optional<views::CalliperKind> kind) {
  kind_ = kind;
  fixed_ = 0;
}

void CalliperTool::pressed(views::PicturePoint at) {
  if (!kind_) return;
  if (fixed_ == 0) {
    open_ = {*kind_, {at, at, at}};
    fixed_ = 1;
    return;
  }
  moved(at);
  fix();
}

void CalliperTool::moved(views::PicturePoint at) {
  for (int i = fixed_; fixed_ > 0 && i < 3; ++i) open_.points[i] = at;
}

void CalliperTool::released(views::PicturePoint at) {
  if (fixed_ == 0) return;
  const auto& last = open_.points[fixed_ - 1];
  if (std::hypot(at.lateral_mm - last.lateral_mm, at.axial_mm - last.axial_mm) < kClick_mm) return;
  moved(at);
  fix();
}

void CalliperTool::fix() {
  if (++fixed_ < pointsOf(open_.kind)) return;
  done_.push_back(open_);
  fixed_ = 0;
}

void CalliperTool::clear() {
  setDone({});
}

void CalliperTool::setDone(std::vector<views::Calliper> callipers) {
  done_ = std::move(callipers);
  fixed_ = 0;
}

std::vector<views::Calliper> CalliperTool::callipers() const {
  auto all = done_;
  if (fixed_ > 0) all.push_back(open_);
  return all;
}

}  // namespace insonate::train
