#pragma once

#include <QDate>
#include <QObject>
#include <QTimer>
#include <chrono>
#include <functional>
#include <utility>

namespace insonate::ui {

/// Calls `changed` within a minute after the date has changed, even if the computer slept over midnight or its clock
/// was set. Use this class for texts that depend on the date. May be used only on the window's thread.
class DayWatch final : public QObject {
 public:
  DayWatch(std::function<void()> changed, QObject* parent, std::function<QDate()> today = &QDate::currentDate)
      : QObject(parent), changed_(std::move(changed)), today_(std::move(today)), day_(today_()) {
    connect(&timer_, &QTimer::timeout, this, &DayWatch::checkDate);
    timer_.start(std::chrono::minutes(1));
  }

  void checkDate() {
    if (std::exchange(day_, today_()) != day_) changed_();
  }

 private:
  std::function<void()> changed_;
  std::function<QDate()> today_;
  QDate day_;
  QTimer timer_;
};

}  // namespace insonate::ui
