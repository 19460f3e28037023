#pragma once

#include "RayCaster.h"

#include <array>
#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace insonate::views {

/// An image with one ray for each pixel.
struct CastPicture {
  CastTask task;
  std::vector<std::uint8_t> rgba;  ///< colors and opacities as RayCaster::castRow() writes them
};

/// Casts rays on its own low-priority threads, for images that take longer than the window may wait. All calls return
/// at once. Work on a task that is no longer needed stops within one row.
class Refiner {
 public:
  static constexpr int kEyes = 2;

  /// `news` is called on other threads when an image or the prepared CT is ready.
  explicit Refiner(std::function<void()> news);
  ~Refiner();

  /// Prepares the CT of this patient for casting, unless that is done or in progress.
  void prepare(std::shared_ptr<const PatientCase> patient);
  /// The volume that was prepared last; null before the first.
  std::shared_ptr<const CastVolume> volume() const;

  /// Requests an image for this eye; replaces the earlier request.
  void want(int eye, CastTask task);
  /// Drops all requests.
  void rest();
  /// The image that was finished last for this eye; null before the first.
  std::shared_ptr<const CastPicture> picture(int eye) const;
  /// Tells whether this task is the latest request or in progress.
  bool makes(int eye, const CastTask& task) const;

 private:
  struct Work {
    std::shared_ptr<CastPicture> picture;
    std::unique_ptr<RayCaster> caster;
    int next = 0, done = 0;  ///< numbers of rows that were begun and finished
    std::atomic<bool> left{false};
  };
  void run();
  void castNextRays(std::unique_lock<std::mutex>& lock, int eye);
  int eyeInWork() const;

  std::function<void()> news_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::shared_ptr<const PatientCase> unprepared_, prepared_;
  std::shared_ptr<const CastVolume> volume_;
  std::array<std::shared_ptr<Work>, kEyes> works_;
  std::array<std::shared_ptr<const CastPicture>, kEyes> pictures_;
  bool ends_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace insonate::views
