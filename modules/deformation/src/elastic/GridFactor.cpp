#include "elastic/GridFactor.h"

#include "elastic/FrontKernel.h"

#include <algorithm>

namespace insonate::elastic {

void GridFactor::prepare(int columns, int rows) {
  if (columns == order_.columns() && rows == order_.rows()) return;
  order_.arrange(columns, rows);
  panels_.assign(order_.factorSize() + GridMatrix::kPadding, 0.0f);
  std::size_t largest = 0;
  for (auto& side : updates_) {
    const std::size_t depths = order_.updateSize().size();
    side.resize(std::max(side.size(), depths));
    for (std::size_t depth = 0; depth < depths; ++depth)
      side[depth].assign(order_.updateSize()[depth] + GridMatrix::kPadding, 0.0f);
  }
  for (const GridOrder::Front& front : order_.fronts())
    largest = std::max(largest, std::size_t(front.own + front.border));
  border_.assign(largest + GridMatrix::kPadding, 0.0f);
  ordered_.assign(order_.unknowns() + GridMatrix::kPadding, 0.0f);
}

bool GridFactor::factor(const GridMatrix& matrix, std::vector<float>& x) {
  order(x);
  const FrontWork work{order_, matrix, panels_.data(), ordered_.data(), updates_};
  int notPositive = 0;
  for (int f = 0; f < static_cast<int>(order_.fronts().size()); ++f) notPositive += eliminateFront(work, f);
  if (notPositive > 0) return false;
  substituteBackward(order_, panels_.data(), ordered_.data(), border_.data());
  restore(x);
  return true;
}

void GridFactor::solve(std::vector<float>& x) {
  order(x);
  substituteForward(order_, panels_.data(), ordered_.data(), border_.data());
  substituteBackward(order_, panels_.data(), ordered_.data(), border_.data());
  restore(x);
}

void GridFactor::order(const std::vector<float>& x) {
  const std::vector<int>& place = order_.placeOfNode();
  for (std::size_t n = 0; n < place.size(); ++n) {
    ordered_[place[n]] = x[2 * n];
    ordered_[place[n] + 1] = x[2 * n + 1];
  }
}

void GridFactor::restore(std::vector<float>& x) const {
  const std::vector<int>& place = order_.placeOfNode();
  for (std::size_t n = 0; n < place.size(); ++n) {
    x[2 * n] = ordered_[place[n]];
    x[2 * n + 1] = ordered_[place[n] + 1];
  }
}

}  // namespace insonate::elastic
