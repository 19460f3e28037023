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

/// What the check found, the worst first; a finding with a place brings the crosshair there.
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
