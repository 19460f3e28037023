#pragma once

#include <QWidget>

class QLabel;

namespace insonate {
struct Procedure;
struct AttemptView;
}  // namespace insonate

namespace insonate::train {

/// The steps of a procedure: done, due with instructions, and the errors, the latest first.
class StepList final : public QWidget {
 public:
  explicit StepList(QWidget* parent = nullptr);

  /// Shows an attempt; without the steps, only errors. Returns whether it needs another height than before.
  bool show(const Procedure& procedure, const AttemptView& view, bool withSteps);

 private:
  QLabel *steps_, *say_, *later_, *findings_;
};

}  // namespace insonate::train
