#pragma once

#include <QWidget>

class QFormLayout;
class QLabel;
class QLineEdit;

namespace insonate::prepare {

class PrepareSession;

/// Facts about the case; its title can be changed.
class CaseFacts : public QWidget {
 public:
  explicit CaseFacts(PrepareSession& session, QWidget* parent = nullptr);

 private:
  QLabel* addFact(QFormLayout& form, const QString& name);
  void showCase();
  void showOrigin();
  void showMeasures();

  PrepareSession& session_;
  QLineEdit* title_;
  QLabel *size_, *spacing_, *orientation_, *range_, *place_, *source_, *notes_;
};

}  // namespace insonate::prepare
