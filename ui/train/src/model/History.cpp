#include "History.h"

#include "StatusLine.h"

#include <QUndoCommand>
#include <utility>

namespace insonate::train {

namespace {

constexpr int kKeyedStep = 1;  // QUndoCommand::id() of steps that may be joined

void sayOutcome(History::Outcome outcome, const History& history, StatusLine& status, const QString& done,
                const QString& nothing) {
  if (outcome == History::Outcome::Done) status.showMessage(done.arg(history.lastStepName()));
  if (outcome == History::Outcome::Nothing) status.showMessage(nothing);
}

}  // namespace

class History::Step final : public QUndoCommand {
 public:
  /// `mayJoin`: soon enough after the step before.
  Step(const QString& what, Exchange exchange, QString key, Check check, bool mayJoin)
      : QUndoCommand(what),
        exchange_(std::move(exchange)),
        check_(std::move(check)),
        key_(std::move(key)),
        mayJoin_(mayJoin) {}

  bool isPossible() const { return !check_ || check_(); }

  int id() const override { return key_.isEmpty() ? -1 : kKeyedStep; }
  /// The state before the first of the joined steps is stored already.
  bool mergeWith(const QUndoCommand* next) override {
    const auto& step = static_cast<const Step&>(*next);
    return step.mayJoin_ && step.key_ == key_;
  }
  void undo() override { exchange_(); }
  void redo() override {
    // The stack calls this for a new step, too.
    if (std::exchange(isMade_, true)) exchange_();
  }

 private:
  Exchange exchange_;
  Check check_;
  QString key_;
  bool mayJoin_, isMade_ = false;
};

History::History() {
  steps_.setUndoLimit(kMost);
}

void History::add(const QString& what, Exchange exchange, const QString& key, Check check) {
  const auto now = std::chrono::steady_clock::now();
  const bool mayJoin = open_ && now - lastAdded_ < kOneStep;
  lastAdded_ = now;
  open_ = true;
  steps_.push(new Step(what, std::move(exchange), key, std::move(check), mayJoin));
}

void History::clear() {
  steps_.clear();
  open_ = false;
}

History::Outcome History::undo() {
  return apply(steps_.index() - 1, &QUndoStack::undo);
}

History::Outcome History::redo() {
  return apply(steps_.index(), &QUndoStack::redo);
}

History::Outcome History::apply(int index, void (QUndoStack::*act)()) {
  const auto* step = static_cast<const Step*>(steps_.command(index));
  if (!step) return Outcome::Nothing;
  open_ = false;
  if (!step->isPossible()) return Outcome::Refused;
  lastStepName_ = step->text();
  (steps_.*act)();
  return Outcome::Done;
}

void undoStep(History& history, StatusLine& status) {
  sayOutcome(history.undo(), history, status, StatusLine::tr("Undone: %1."),
             StatusLine::tr("There is nothing to undo."));
}

void redoStep(History& history, StatusLine& status) {
  sayOutcome(history.redo(), history, status, StatusLine::tr("Redone: %1."),
             StatusLine::tr("There is nothing to redo."));
}

}  // namespace insonate::train
