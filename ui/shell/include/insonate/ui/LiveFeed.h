#pragma once

#include <insonate/simulator/LiveImaging.h>

#include <QObject>
#include <atomic>
#include <functional>
#include <memory>

namespace insonate::ui {

/// Notifies the window's thread of new images of a LiveImaging. At most one message is queued, even if several images
/// arrive, and the imaging thread never waits for the window.
class LiveFeed : public QObject {
 public:
  /// `news` is called on the window's thread after LiveImaging has made a new image or changed its state.
  explicit LiveFeed(std::function<void()> news, QObject* parent = nullptr);
  ~LiveFeed() override;

  /// Replaces the LiveImaging; null: none. Messages of the previous object are discarded.
  void setImaging(std::unique_ptr<LiveImaging> live);
  LiveImaging* imaging() { return live_.get(); }
  const LiveImaging* imaging() const { return live_.get(); }

 protected:
  bool event(QEvent* event) override;

 private:
  std::function<void()> news_;
  std::atomic<bool> posted_{false};
  std::unique_ptr<LiveImaging> live_;
};

}  // namespace insonate::ui
