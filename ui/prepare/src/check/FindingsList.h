#pragma once

#include <insonate/cases/CaseCheck.h>

#include <QWidget>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace insonate::prepare {

struct PrepareModel;

/// Returns the number of findings in words: "2 errors, 1 warning"; "fit for training" if there are no errors and no
/// warnings.
QString findingCount(const std::vector<Finding>& findings);

/// Shows the verdict and the findings of the check: errors, warnings, notes. Selecting a finding shows its position and
/// structure, or the step that makes a missing structure. While the check runs again, the last findings stay.
class FindingsList : public QWidget {
  Q_OBJECT

 public:
  explicit FindingsList(PrepareModel& shared, QWidget* parent = nullptr);

 Q_SIGNALS:
  /// Emitted when the user wants to make a missing structure.
  void labelRequested(int label);

 private:
  void refresh();
  QWidget* row(const Finding& finding);
  QPushButton* way(const Finding& finding);

  PrepareModel& shared_;
  QLabel* state_;
  QPushButton* again_;
  QWidget* list_ = nullptr;
  QVBoxLayout* box_;
};

}  // namespace insonate::prepare
