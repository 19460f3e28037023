#pragma once

#include <QObject>
#include <QString>
#include <QTimer>

namespace insonate::prepare {

/// A sentence about the last event, which expires after some seconds.
class Notice : public QObject {
  Q_OBJECT

 public:
  explicit Notice(QObject* parent);

  static constexpr int kShown_ms = 7000;
  void showMessage(const QString& sentence);
  /// Discards the sentence without emitting a signal, since another event follows.
  void clear() { text_.clear(); }
  /// The sentence; empty when it has expired.
  const QString& text() const { return text_; }

 Q_SIGNALS:
  void changed();

 private:
  QString text_;
  QTimer shown_;
};

}  // namespace insonate::prepare
