#pragma once

#include <QUndoCommand>
#include <string>

namespace insonate::prepare {

class LabelSession;

/// A step of labeling among the window's edits; the edits of one step of the guide are one command. Their changes are
/// in LabelEdit, in the same order.
class LabelCommand : public QUndoCommand {
 public:
  /// `of`: the step of the guide; empty for none.
  LabelCommand(LabelSession& session, const QString& name, std::string of)
      : QUndoCommand(name), session_(session), of_(std::move(of)) {}
  void undo() override;
  void redo() override;
  int id() const override { return 2; }
  bool mergeWith(const QUndoCommand* next) override;

 private:
  LabelSession& session_;
  std::string of_;
  int steps_ = 1;
  bool isDone_ = true;  ///< by the tool, before the command was made
};

}  // namespace insonate::prepare
