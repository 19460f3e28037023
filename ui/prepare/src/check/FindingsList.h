#pragma once

#include <insonate/cases/CaseCheck.h>

#include <QWidget>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace insonate::prepare {

struct PrepareModel;

/// "2 errors, 1 doubt", "no findings".
QString findingCount(const std::vector<Finding>& findings);

/// The verdict and the findings of the check: errors, warnings, notes. A finding leads to its place and structure, or
/// to the step that makes a missing structure. The last findings stay while the check runs again.
class FindingsList : public QWidget {
  Q_OBJECT

 public:
  explicit FindingsList(PrepareModel& shared, QWidget* parent = nullptr);

 Q_SIGNALS:
  /// A structure that is missing is to be made.
  void labelWanted(int label);
  /// A place that is missing is to be marked: a kind of PlacesBox.
  void placeWanted(const QString& kind);

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
