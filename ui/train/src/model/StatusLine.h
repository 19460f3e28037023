#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <optional>

namespace insonate::train {

/// The sentence in the window's status bar: an event for some seconds, after that the present state or the next thing
/// to do.
class StatusLine : public QObject {
  Q_OBJECT

 public:
  static constexpr int kMessage_ms = 7000;

  explicit StatusLine(QObject* parent = nullptr);

  /// The sentence that is shown now.
  QString message() const { return message_; }
  /// Shows a sentence about an event for some seconds.
  void showMessage(const QString& sentence);
  /// Sets the next thing to do, shown when there is no recent event; empty: the default hint.
  void setHint(const QString& hint);
  /// Sets the function that returns a sentence about the present state; nullopt: the hint is shown instead.
  void setState(std::function<std::optional<QString>()> state) { state_ = std::move(state); }

 Q_SIGNALS:
  void messageChanged();

 private:
  QString standing() const;

  QString message_, hint_;
  QTimer messageTimer_;
  std::function<std::optional<QString>()> state_;
};

}  // namespace insonate::train
