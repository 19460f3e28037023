#pragma once

#include <QFrame>
#include <QString>

class QLabel;
class QToolButton;

namespace insonate::ui {

/// Shows an error and advice without blocking the window. Details can be expanded. Hidden if there is no error; closed
/// by its button or Escape.
class ErrorPanel : public QFrame {
  Q_OBJECT

 public:
  explicit ErrorPanel(QWidget* parent = nullptr);

  /// `what` and `advice` are sentences. The lines of `what` after the first, and `details`, are collapsed.
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
