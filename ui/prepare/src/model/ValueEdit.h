#pragma once

#include <QString>
#include <QUndoCommand>
#include <functional>
#include <utility>

namespace insonate::prepare {

/// An undoable change of one value of the model. `apply` sets the value and announces it.
template <class T>
class ValueEdit : public QUndoCommand {
 public:
  using Apply = std::function<void(const T&)>;

  ValueEdit(T before, T after, Apply apply, const QString& what, QUndoCommand* parent = nullptr)
      : QUndoCommand(what, parent), before_(std::move(before)), after_(std::move(after)), apply_(std::move(apply)) {}
  void undo() override { apply_(before_); }
  void redo() override { apply_(after_); }

 private:
  T before_, after_;
  Apply apply_;
};

}  // namespace insonate::prepare
