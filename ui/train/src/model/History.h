#pragma once

#include <QString>
#include <QUndoStack>
#include <chrono>
#include <functional>

namespace insonate::train {

class StatusLine;

/// The user's undoable steps of all kinds, in one order, on a QUndoStack. A step exchanges the present state with the
/// former one, so that the same function serves undo and redo. For one thread.
class History {
 public:
  static constexpr int kMost = 200;
  /// Consecutive steps with the same key are joined if they follow within this time, e.g. those of a dragged slider.
  static constexpr std::chrono::milliseconds kOneStep{1000};

  /// Exchanges the states.
  using Exchange = std::function<void()>;
  /// Tells whether a step can be undone or redone now; if not, shows the reason. QUndoStack knows no refusal, so this
  /// is called before.
  using Check = std::function<bool()>;

  History();

  /// Adds a step that was made already; `what` is shown after "Undone: ". Steps that could be redone are dropped.
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
  bool open_ = false;  ///< the next step may be joined with the last one
  std::chrono::steady_clock::time_point lastAdded_;
};

/// Undoes the last step and shows its name in the status line, or that there is none.
void undoStep(History& history, StatusLine& status);
/// Redoes the step that was undone last and shows its name in the status line, or that there is none.
void redoStep(History& history, StatusLine& status);

}  // namespace insonate::train
