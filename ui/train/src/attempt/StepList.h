#pragma once

#include <QString>
#include <QWidget>
#include <cstddef>
#include <optional>

class QLabel;

namespace insonate {
struct Procedure;
struct AttemptView;
}  // namespace insonate

namespace insonate::train {

/// Lists the steps of a procedure: done steps, due steps with instructions, and errors, the latest first.
class StepList final : public QWidget {
 public:
  explicit StepList(QWidget* parent = nullptr);

  /// Shows an attempt. If `withSteps` is false, shows only the errors of the attempt. `act`: the trainee's next action,
  /// shown with the due step. `standing`: finding that another widget shows. Returns whether the list needs another
  /// height than before.
  bool show(const Procedure& procedure, const AttemptView& view, bool withSteps, const QString& act,
            std::optional<std::size_t> standing);
  /// Returns the rows of this widget that the user must see: the due step with the next action, and a line of the steps
  /// before and after it.
  QRect dueRows() const;

 private:
  QLabel *steps_, *say_, *act_, *later_, *findings_;
};

/// Returns an error as rich text: sign, severity, time, and the sentence of its rule. `finding`: index into
/// AttemptView::findings.
QString errorText(const Procedure& procedure, const AttemptView& view, std::size_t finding);

}  // namespace insonate::train
