#pragma once

#include <insonate/core/ProcessorTime.h>

#include <QObject>
#include <QTimer>
#include <algorithm>
#include <utility>

namespace insonate::test {

/// Longest time that the window's thread worked without processing events, in processor time.
class Pauses : public QObject {
 public:
  Pauses() {
    QObject::connect(&beat_, &QTimer::timeout, this, [this] { note(); });
    beat_.start(1);
  }
  /// Since it was asked last.
  double longest_ms() {
    note();
    return std::exchange(longest_ms_, 0);
  }

 private:
  void note() {
    const double now_ms = threadTime_ms();
    longest_ms_ = std::max(longest_ms_, now_ms - last_ms_);
    last_ms_ = now_ms;
  }
  QTimer beat_;
  double last_ms_ = threadTime_ms(), longest_ms_ = 0;
};

}  // namespace insonate::test
