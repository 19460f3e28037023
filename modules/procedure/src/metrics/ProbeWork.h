#pragma once

#include <insonate/core/Transform.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace insonate::metrics {

/// Counts fast movements of the probe. A movement begins when the speed exceeds `limit`, and ends once the speed has
/// stayed below `limit` for 0.2 s.
class Movements {
 public:
  explicit Movements(double limit) : limit_(limit) {}
  void follow(std::int64_t time_us, double speed);
  int count() const { return count_; }

 private:
  double limit_;
  std::optional<std::int64_t> fast_us_;
  int count_ = 0;
};

/// Computes the metrics of the probe's motion and force.
class ProbeWork {
 public:
  /// motions of the probe below this distance count as trembling and are ignored
  static constexpr double kStep_mm = 1;
  static constexpr std::int64_t kSpeed_us = 50'000;  ///< time over which a speed is computed

  /// Adds a sample. `counting`, true: the probe's path counts at this time, i.e. from the first puncture of the skin to
  /// the first puncture of the vein.
  void follow(std::int64_t time_us, const std::optional<Transform>& patientFromProbe, double force_N, bool counting);

  std::optional<double> path_mm() const;
  std::optional<int> translations() const;
  std::optional<int> rotations() const;
  std::optional<double> forceMean_N() const;
  std::optional<double> forceMax_N() const;

 private:
  struct Place {
    std::int64_t time_us = 0;
    Transform patientFromProbe;
  };
  void move(const Place& place);
  void walk(Vec3 at_mm, bool counting);

  bool held_ = false;
  std::optional<Vec3> last_mm_;
  double path_mm_ = 0;
  bool counted_ = false;
  std::array<Place, 128> recent_;  ///< ring buffer of the last poses; holds more than kSpeed_us at 1 kHz
  std::size_t begin_ = 0, size_ = 0;
  Movements translations_{50}, rotations_{50};  ///< movements faster than 50 mm/s and 50 deg/s
  double forceSum_N_ = 0, forceMax_N_ = 0;
  std::int64_t pressed_ = 0;
};

}  // namespace insonate::metrics
