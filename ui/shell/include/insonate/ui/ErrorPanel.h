#pragma once

#include <QFrame>
#include <QString>

class QLabel;
class QToolButton;

namespace insonate::ui {

/// A panel that shows an error and advice without blocking the window. Details can be expanded. The panel is hidden if
/// there is no error; its button or Escape closes it.
class ErrorPanel : public QFrame {
  Q_OBJECT

 public:
  explicit ErrorPanel(QWidget* parent = nullptr);

  /// Shows an error. `what` and `advice` are sentences. Lines of `what` after the first are shown with the collapsed
  /// `details`.
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
