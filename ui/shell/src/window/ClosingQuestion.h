#pragma once

#include <QDialog>
#include <QString>

namespace insonate::ui {

/// Asks before the window closes over something that would be lost, without stopping it meanwhile.
class ClosingQuestion : public QDialog {
  Q_OBJECT

 public:
  /// What is being done ("Importing neck-ct"), and the title of a case that is not on disk; one of them may be empty.
  ClosingQuestion(const QString& job, const QString& unsaved, QWidget* parent);

 Q_SIGNALS:
  void closeChosen();
  void saveChosen();
};

}  // namespace insonate::ui
