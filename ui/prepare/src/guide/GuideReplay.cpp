#include "GuideReplay.h"

#include "../label/LabelSession.h"

#include <QUndoStack>
#include <utility>

namespace insonate::prepare {

bool GuideReplay::run(std::vector<LabelStep> steps, std::size_t first, std::size_t end, const QString& name,
                      Done done) {
  const std::vector<LabelStep> all = labels_.recipe().steps;
  if (!takeBackTo(first)) return false;
  const auto at = [&](std::size_t index) { return all.begin() + std::ptrdiff_t(index); };
  before_.assign(at(first), all.end());
  todo_.assign(steps.begin(), steps.end());
  todo_.insert(todo_.end(), at(end), all.end());
  again_ = all.size() - end, first_ = first;
  places_.clear();
  name_ = name, done_ = std::move(done);
  running_ = true, restoring_ = false;
  ++number_;
  next();
  return true;
}

/// Either all the way or not at all.
bool GuideReplay::takeBackTo(std::size_t count) {
  const int here = undo_.index();
  for (std::size_t steps = labels_.recipe().steps.size(); steps > count; steps = labels_.recipe().steps.size()) {
    if (undo_.canUndo()) undo_.undo();
    if (undo_.canUndo() || labels_.recipe().steps.size() <= count) continue;
    while (undo_.index() < here && undo_.canRedo()) undo_.redo();
    return false;
  }
  return true;
}

void GuideReplay::next() {
  const std::size_t recorded = labels_.recipe().steps.size();
  if (todo_.size() <= again_) places_.push_back(recorded);
  if (todo_.empty()) {
    running_ = false;
    return std::exchange(done_, {})(places_, !restoring_);
  }
  LabelStep step = std::move(todo_.front());
  todo_.pop_front();
  labels_.run(std::move(step), name_, [this, number = number_](const Result<LabelChange>& change) {
    if (number != number_) return;
    if (change) return next();
    fail();
  });
}

void GuideReplay::fail() {
  // What was there is made again; if that fails, too, as much is there as could be made.
  if (restoring_ || before_.empty() || !takeBackTo(first_)) {
    if (!restoring_) takeBackTo(first_);
    running_ = false;
    return std::exchange(done_, {})({}, false);
  }
  restoring_ = true;
  todo_.assign(before_.begin(), before_.end());
  again_ = todo_.size();
  places_.clear();
  next();
}

}  // namespace insonate::prepare
