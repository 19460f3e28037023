#pragma once

#include <QFrame>

class QLabel;
class QTimer;
class QToolButton;

namespace insonate::ui {

/// The line at the bottom: what just happened or the next thing to do, the engine and its rate, help.
class StatusStrip : public QFrame {
  Q_OBJECT

 public:
  explicit StatusStrip(QWidget* parent = nullptr);

  /// Sets the text about the next thing to do, shown while there is no event.
  void setStanding(const QString& text);
  /// Shows an event; the standing text returns after a while. With a folder, a link opens it.
  void say(const QString& text, const QString& folder = {});
  /// `note`: why this engine, or empty.
  void setEngine(const QString& text, const QString& note);

  QString text() const;

 Q_SIGNALS:
  void helpWanted();

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
