#pragma once

#include <QUndoCommand>
#include <functional>
#include <string>
#include <utility>

namespace insonate::prepare {

/// A step of labeling among the window's edits; the edits of one step of the guide are one command. Their changes are
/// in LabelEdit, in the same order.
class LabelCommand : public QUndoCommand {
 public:
  /// `undo` and `redo` apply to one recorded step; `undo` returns false if the step was discarded. `of`: the step of
  /// the guide; empty for none.
  LabelCommand(std::function<bool()> undo, std::function<void()> redo, const QString& name, std::string of)
      : QUndoCommand(name), undo_(std::move(undo)), redo_(std::move(redo)), of_(std::move(of)) {}
  void undo() override;
  void redo() override;
  int id() const override { return 2; }
  bool mergeWith(const QUndoCommand* next) override;

 private:
  std::function<bool()> undo_;
  std::function<void()> redo_;
  std::string of_;
  int steps_ = 1;
  bool isDone_ = true;  ///< by the tool, before the command was made
};

}  // namespace insonate::prepare
