#pragma once

#include <QUndoCommand>

namespace insonate::prepare {

class LabelSession;

/// A step of labelling among the window's edits. What it has changed lies in LabelEdit, in the same order.
class LabelCommand : public QUndoCommand {
 public:
  LabelCommand(LabelSession& session, const QString& name) : QUndoCommand(name), session_(session) {}
  void undo() override;
  void redo() override;

 private:
  LabelSession& session_;
  bool isDone_ = true;  ///< by the tool, before the command was made
};

}  // namespace insonate::prepare
