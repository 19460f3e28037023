#include "StepReplay.h"

#include "LabelSession.h"

#include <QTimer>
#include <QUndoStack>
#include <utility>

namespace insonate::prepare {
namespace {

constexpr int kUntilFree_ms = 50;

}  // namespace

bool StepReplay::run(std::vector<LabelStep> steps, std::size_t first, std::size_t end, const QString& name, Done done) {
  const std::vector<LabelStep> all = labels_.recipe().steps;
  here_ = undo_.index();
  if (!undoTo(first)) return false;
  const auto at = [&](std::size_t index) { return all.begin() + std::ptrdiff_t(index); };
  before_.assign(at(first), all.end());
  todo_.assign(steps.begin(), steps.end());
  todo_.insert(todo_.end(), at(end), all.end());
  again_ = all.size() - end, first_ = first;
  name_ = name, done_ = std::move(done);
  running_ = true, restoring_ = false;
  ++number_;
  next();
  return true;
}

/// Undoes all steps after the first `count`, or none of them.
bool StepReplay::undoTo(std::size_t count) {
  const int here = undo_.index();
  for (std::size_t steps = labels_.recipe().steps.size(); steps > count; steps = labels_.recipe().steps.size()) {
    if (undo_.canUndo()) undo_.undo();
    if (undo_.canUndo() || labels_.recipe().steps.size() <= count) continue;
    while (undo_.index() < here && undo_.canRedo()) undo_.redo();
    return false;
  }
  return true;
}

void StepReplay::next() {
  if (todo_.empty()) return end(!restoring_);
  const bool again = todo_.size() <= again_;
  LabelStep step = std::move(todo_.front());
  todo_.pop_front();
  const auto done = [this, number = number_](const Result<LabelChange>& change) {
    if (number != number_) return;
    change ? next() : fail();
  };
  again ? labels_.runAgain(std::move(step), name_, done) : labels_.run(std::move(step), name_, done);
}

/// If nothing new was recorded, the undone steps can still be redone.
bool StepReplay::wasRedone() {
  if (labels_.recipe().steps.size() != first_) return false;
  while (undo_.index() < here_ && undo_.canRedo()) undo_.redo();
  return labels_.recipe().steps.size() == first_ + before_.size();
}

void StepReplay::fail() {
  if (restoring_ || wasRedone()) return end(false);
  restoring_ = true;
  restoreSoon();
}

/// A user who has canceled may start another action, which has precedence.
void StepReplay::restoreSoon() {
  QTimer::singleShot(kUntilFree_ms, this, [this, number = number_] {
    if (number == number_) labels_.isFree() ? restore() : restoreSoon();
  });
}

void StepReplay::restore() {
  // If that fails, too, the steps that could be made remain.
  if (!undoTo(first_)) return end(false);
  todo_.assign(before_.begin(), before_.end());
  again_ = todo_.size();
  next();
}

void StepReplay::end(bool well) {
  running_ = false;
  std::exchange(done_, {})(well);
}

}  // namespace insonate::prepare
