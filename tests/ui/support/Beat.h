#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <algorithm>

namespace insonate::test {

/// Longest time during which the window's thread did not process events.
class Beat {
 public:
  Beat() {
    beat_.setInterval(1);
    QObject::connect(&beat_, &QTimer::timeout, [this] { longest_ms_ = std::max(longest_ms_, since_.restart()); });
  }
  void start() {
    beat_.start();
    since_.start();
    longest_ms_ = 0;
  }
  qint64 longest_ms() const { return longest_ms_; }

 private:
  QTimer beat_;
  QElapsedTimer since_;
  qint64 longest_ms_ = 0;
};

}  // namespace insonate::test
