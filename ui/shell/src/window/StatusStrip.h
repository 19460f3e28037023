#pragma once

#include <QFrame>

class QLabel;
class QTimer;
class QToolButton;

namespace insonate::ui {

/// The window's bottom line: the last event or the next thing to do, the engine and its frame rate, help.
class StatusStrip : public QFrame {
  Q_OBJECT

 public:
  explicit StatusStrip(QWidget* parent = nullptr);

  /// Sets the text about the next thing to do; shown if there is no recent event.
  void setStanding(const QString& text);
  /// Shows an event; after a while the text of setStanding() is shown again. If `folder` is given, a link opens the
  /// folder.
  void showMessage(const QString& text, const QString& folder = {});
  /// Shows the engine. `note` says why this engine was chosen; may be empty.
  void setEngine(const QString& text, const QString& note);

  QString text() const;

 Q_SIGNALS:
  void helpRequested();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void write(const QString& text, const QString& folder = {});
  void elide();

  QString standing_, written_;
  QLabel *text_, *engine_;
  QTimer* timer_;
};

}  // namespace insonate::ui
