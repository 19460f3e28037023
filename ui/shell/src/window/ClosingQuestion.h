#pragma once

#include <QDialog>
#include <QString>

namespace insonate::ui {

/// Asks before the window closes over something that is being done, without stopping it meanwhile.
class ClosingQuestion : public QDialog {
  Q_OBJECT

 public:
  /// What is being done: "Importing neck-ct".
  ClosingQuestion(const QString& job, QWidget* parent);

 Q_SIGNALS:
  void closeChosen();
};

}  // namespace insonate::ui
