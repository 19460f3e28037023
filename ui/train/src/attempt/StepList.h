#pragma once

#include <QWidget>

class QLabel;

namespace insonate {
struct Procedure;
struct AttemptView;
}  // namespace insonate

namespace insonate::train {

/// The steps of a procedure: what is done, what is due and how it is done, and what went wrong, the latest first.
class StepList final : public QWidget {
 public:
  explicit StepList(QWidget* parent = nullptr);

  /// Without the steps: what went wrong alone. Returns whether it needs another height than before.
  bool show(const Procedure& procedure, const AttemptView& view, bool withSteps);

 private:
  QLabel *steps_, *say_, *later_, *findings_;
};

}  // namespace insonate::train
