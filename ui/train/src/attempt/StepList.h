#pragma once

#include <QString>
#include <QWidget>

class QLabel;

namespace insonate {
struct Procedure;
struct AttemptView;
}  // namespace insonate

namespace insonate::train {

/// Lists the steps of a procedure: done steps, due steps with instructions, and errors, the latest first.
class StepList final : public QWidget {
 public:
  /// `finishKeys`: keys of the command that finishes an attempt.
  explicit StepList(const QString& finishKeys, QWidget* parent = nullptr);

  /// Shows an attempt; if not `withSteps`, only its errors. Returns whether the list needs another height than before.
  bool show(const Procedure& procedure, const AttemptView& view, bool withSteps);

 private:
  QString finishKeys_;
  QLabel *steps_, *say_, *later_, *findings_;
};

}  // namespace insonate::train
