#pragma once

#include "RayCaster.h"

#include <array>
#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace insonate::views {

/// An image of which every pixel has its ray.
struct CastPicture {
  CastTask task;
  std::vector<std::uint8_t> rgba;  ///< as RayCaster gives it
};

/// Casts rays that take longer than a window may wait, on threads of low priority that it owns. All calls return at
/// once; work on a task that is no longer needed stops within a row.
class Refiner {
 public:
  static constexpr int kEyes = 2;

  /// `news` is called on other threads when something has become ready.
  explicit Refiner(std::function<void()> news);
  ~Refiner();

  /// Makes this patient's CT ready for casting, unless it is or will be.
  void prepare(std::shared_ptr<const PatientCase> patient);
  /// The last one made; null before.
  std::shared_ptr<const CastVolume> volume() const;

  /// Replaces the request for this eye.
  void want(int eye, CastTask task);
  /// Drops all requests.
  void rest();
  /// The last one made for this eye; null before.
  std::shared_ptr<const CastPicture> picture(int eye) const;
  /// Tells whether this task is the latest request, or is in work.
  bool makes(int eye, const CastTask& task) const;

 private:
  struct Work {
    std::shared_ptr<CastPicture> picture;
    std::unique_ptr<RayCaster> caster;
    int next = 0, done = 0;  ///< rows
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
