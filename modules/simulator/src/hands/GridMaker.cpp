#include "hands/GridMaker.h"

#include <insonate/tissue/Labels.h>

#include <utility>

namespace insonate {

GridMaker::GridMaker() : thread_([this](const std::stop_token& stop) { run(stop); }) {}

GridMaker::~GridMaker() {
  thread_.request_stop();
  changed_.notify_all();
}

void GridMaker::want(std::shared_ptr<const LabelMap> labels, Vec3 center_mm) {
  {
    const std::lock_guard lock(mutex_);
    wish_ = {std::move(labels), center_mm, wish_.number + 1};
    made_.reset();
  }
  changed_.notify_all();
}

void GridMaker::forget() {
  want(nullptr, {});
}

std::optional<GridMaker::Made> GridMaker::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(made_, std::nullopt);
}

void GridMaker::run(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (changed_.wait(lock, stop, [this] { return begun_ != wish_.number; })) {
    const Wish wish = wish_;
    begun_ = wish.number;
    if (!wish.labels) continue;
    lock.unlock();
    const Progress asked = [&](std::string_view, double) {
      const std::lock_guard again(mutex_);
      return !stop.stop_requested() && wish_.number == wish.number;
    };
    findVeins(wish.labels, asked);
    const auto grid = TissueGrid::fromLabels(*wish.labels, wish.center_mm, kReach_mm, asked);
    lock.lock();
    if (wish_.number == wish.number && !stop.stop_requested())
      made_ = Made{grid ? *grid : nullptr, veins_, wish.center_mm};
  }
}

void GridMaker::findVeins(const std::shared_ptr<const LabelMap>& labels, const Progress& progress) {
  if (veinsOf_.lock() == labels) return;
  auto lines = centerLines(*labels, kVein, progress);
  if (!lines) return;
  veinsOf_ = labels;
  veins_ = std::make_shared<const std::vector<CenterLine>>(std::move(*lines));
}

}  // namespace insonate
