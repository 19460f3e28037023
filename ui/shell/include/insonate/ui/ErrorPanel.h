#pragma once

#include <QFrame>
#include <QString>

class QLabel;
class QToolButton;

namespace insonate::ui {

/// Shows an error and what to do beside the work, without stopping it. Details fold out. Hidden without an error;
/// closed by its button or Escape.
class ErrorPanel : public QFrame {
  Q_OBJECT

 public:
  explicit ErrorPanel(QWidget* parent = nullptr);

  /// `what` and `advice` are sentences; lines of `what` after the first, and `details`, fold away.
  void showError(const QString& what, const QString& advice = {}, const QString& details = {});
  void dismiss();

  QString message() const;
  QString details() const;

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void fold(bool open);

  QLabel *what_, *advice_, *details_;
  QToolButton *more_, *close_;
};

}  // namespace insonate::ui
