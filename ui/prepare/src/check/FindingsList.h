#pragma once

#include <insonate/cases/CaseCheck.h>

#include <QWidget>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace insonate::prepare {

class PrepareSession;

/// "2 errors, 1 doubt", "no findings".
QString findingCount(const std::vector<Finding>& findings);

/// The verdict, and what the check found: missing or wrong, doubtful, noted. A finding brings the crosshair to its
/// place and selects its structure. The last findings stay while the check runs again.
class FindingsList : public QWidget {
 public:
  explicit FindingsList(PrepareSession& session, QWidget* parent = nullptr);

 private:
  void refresh();
  QWidget* row(const Finding& finding);

  PrepareSession& session_;
  QLabel* state_;
  QPushButton* again_;
  QWidget* list_ = nullptr;
  QVBoxLayout* box_;
};

}  // namespace insonate::prepare
