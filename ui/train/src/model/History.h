#pragma once

#include <QString>
#include <QUndoStack>
#include <chrono>
#include <functional>

namespace insonate::train {

class StatusLine;

/// The user's undoable steps of all kinds, in one order, on a QUndoStack. A step exchanges the present state with the
/// former state, so that the same function serves undo and redo. One object must be used on one thread only.
class History {
 public:
  static constexpr int kMost = 200;
  /// Consecutive steps with the same key are joined into one if the time between them is below this, e.g. steps of a
  /// dragged slider.
  static constexpr std::chrono::milliseconds kOneStep{1000};

  /// Function that exchanges the present and the former state.
  using Exchange = std::function<void()>;
  /// Function that tells whether a step can be undone or redone now; if not, the function shows the reason. The
  /// function is called before undo and redo, since QUndoStack cannot refuse a step.
  using Check = std::function<bool()>;

  History();

  /// Adds a step that was already made; `what` is shown after "Undone: ". Steps that could be redone are discarded.
  void add(const QString& what, Exchange exchange, const QString& key = {}, Check check = {});
  /// Prevents the next step from being joined with the last one.
  void close() { open_ = false; }
  void clear();

  enum class Outcome { Done, Nothing, Refused };
  Outcome undo();
  Outcome redo();
  /// Name of the step that undo() or redo() has applied last.
  const QString& lastStepName() const { return lastStepName_; }

 private:
  class Step;
  Outcome apply(int index, void (QUndoStack::*act)());

  QUndoStack steps_;
  QString lastStepName_;
  bool open_ = false;  ///< true: the next step may be joined with the last one
  std::chrono::steady_clock::time_point lastAdded_;
};

/// Undoes the last step and shows its name in the status line, or that there is none.
void undoStep(History& history, StatusLine& status);
/// Redoes the step that was undone last and shows its name in the status line, or that there is none.
void redoStep(History& history, StatusLine& status);

}  // namespace insonate::train
