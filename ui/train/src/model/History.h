#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace insonate::train {

class StatusLine;

/// The user's undoable steps of all kinds, in one order. A step exchanges the present state with the former one, so
/// that the same step serves undo and redo. For one thread.
class History {
 public:
  static constexpr std::size_t kMost = 200;
  /// Consecutive steps with the same key are joined if they follow within this time, e.g. those of a dragged slider.
  static constexpr std::chrono::milliseconds kOneStep{1000};

  /// Exchanges the states. Returns false, without a change, if that is impossible now.
  using Exchange = std::function<bool()>;

  /// Adds a step; `what` is shown after "Undone: ". Steps that could be redone are dropped.
  void add(std::string what, Exchange exchange, std::string key = {});
  /// Prevents the next step from being joined with the last one.
  void close() { open_ = false; }
  void clear();

  enum class Outcome { Done, Nothing, Refused };
  Outcome undo() { return go(past_, future_); }
  Outcome redo() { return go(future_, past_); }
  /// Name of the step that undo() or redo() has applied last.
  const std::string& lastWords() const { return lastWords_; }

 private:
  struct Step {
    std::string what, key;
    Exchange exchange;
  };
  Outcome go(std::vector<Step>& from, std::vector<Step>& to);

  std::vector<Step> past_, future_;
  std::string lastWords_;
  bool open_ = false;  ///< the next step may be joined with the last one
  std::chrono::steady_clock::time_point lastAdded_;
};

/// Undoes the last step and shows its name in the status line, or that there is none.
void undoStep(History& history, StatusLine& status);
/// Redoes the step that was undone last and shows its name in the status line, or that there is none.
void redoStep(History& history, StatusLine& status);

}  // namespace insonate::train
