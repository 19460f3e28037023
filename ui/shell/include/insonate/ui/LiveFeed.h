#pragma once

#include <insonate/simulator/LiveImaging.h>

#include <QObject>
#include <atomic>
#include <functional>
#include <memory>

namespace insonate::ui {

/// Brings a live probe's images to the window's thread. At most one message waits, however many images arrive, and the
/// simulation never waits for the window.
class LiveFeed : public QObject {
 public:
  /// `news` is called on the window's thread after new images and changes of state.
  explicit LiveFeed(std::function<void()> news, QObject* parent = nullptr);
  ~LiveFeed() override;

  /// Replaces the live probe; null removes it. Messages of the old probe are dropped.
  void set(std::unique_ptr<LiveImaging> live);
  LiveImaging* live() { return live_.get(); }
  const LiveImaging* live() const { return live_.get(); }

 protected:
  bool event(QEvent* event) override;

 private:
  std::function<void()> news_;
  std::atomic<bool> posted_{false};
  std::unique_ptr<LiveImaging> live_;
};

}  // namespace insonate::ui
