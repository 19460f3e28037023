#pragma once

#include <QWidget>

class QFormLayout;
class QLabel;
class QLineEdit;

namespace insonate::prepare {

struct PrepareModel;

/// Shows facts about the case; the user can edit the title.
class CaseFacts : public QWidget {
 public:
  explicit CaseFacts(PrepareModel& shared, QWidget* parent = nullptr);

 private:
  QLabel* addFact(QFormLayout& form, const QString& name);
  void showCase();
  void showOrigin();
  void showMeasures();

  PrepareModel& shared_;
  QLineEdit* title_;
  QLabel *size_, *spacing_, *orientation_, *range_, *place_, *source_, *notes_;
};

}  // namespace insonate::prepare
