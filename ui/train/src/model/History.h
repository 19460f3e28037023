#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace insonate::train {

class StatusLine;

/// The user's undoable steps of every kind, in one order. A step exchanges the present state with the former one, so
/// that the same step serves undo and redo. For one thread.
class History {
 public:
  static constexpr std::size_t kMost = 200;
  /// Steps with one key that follow each other within this time are one, e.g. those of a slider that is dragged.
  static constexpr std::chrono::milliseconds kOneStep{1000};

  /// Exchanges the states; false if that is impossible now; then nothing has changed.
  using Exchange = std::function<bool()>;

  /// Adds a step; `what` completes "Undone: ". Steps that were undone before can no longer be redone.
  void add(std::string what, Exchange exchange, std::string key = {});
  /// The next step does not join the last one.
  void close() { open_ = false; }
  void clear();

  enum class Outcome { Done, Nothing, Refused };
  Outcome undo() { return go(past_, future_); }
  Outcome redo() { return go(future_, past_); }
  /// Name of the step that undo() or redo() applied last.
  const std::string& lastWords() const { return lastWords_; }

 private:
  struct Step {
    std::string what, key;
    Exchange exchange;
  };
  Outcome go(std::vector<Step>& from, std::vector<Step>& to);

  std::vector<Step> past_, future_;
  std::string lastWords_;
  bool open_ = false;  ///< the last step may still be joined
  std::chrono::steady_clock::time_point lastAdded_;
};

/// Undoes the last step and says which it was, or that there is none.
void undoStep(History& history, StatusLine& status);
/// Applies the step undone last again, and says which it was, or that there is none.
void redoStep(History& history, StatusLine& status);

}  // namespace insonate::train
