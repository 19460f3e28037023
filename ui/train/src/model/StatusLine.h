#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <optional>

namespace insonate::train {

/// The sentence at the window's foot: an event for some seconds, then the state or the next thing to do.
class StatusLine : public QObject {
  Q_OBJECT

 public:
  static constexpr int kSaid_ms = 7000;

  explicit StatusLine(QObject* parent = nullptr);

  /// Sentence about the last event, or the next thing to do.
  QString message() const { return message_; }
  /// Shows a sentence about an event for some seconds.
  void say(const QString& sentence);
  /// The next thing to do while nothing has happened; empty for the usual.
  void setHint(const QString& hint);
  /// Sets the function that returns a sentence about the present state; nullopt while the hint applies.
  void setState(std::function<std::optional<QString>()> state) { state_ = std::move(state); }

 Q_SIGNALS:
  void messageChanged();

 private:
  QString standing() const;

  QString message_, hint_;
  QTimer said_;
  std::function<std::optional<QString>()> state_;
};

}  // namespace insonate::train
