#pragma once

#include <insonate/core/Transform.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace insonate::metrics {

/// Counts fast movements. A movement begins when the speed exceeds the limit, and ends once the speed has stayed below
/// the limit for 0.2 s.
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

class ProbeWork {
 public:
  static constexpr double kStep_mm = 1;              ///< smaller motions are trembling and not counted
  static constexpr std::int64_t kSpeed_us = 50'000;  ///< a speed is the difference over this time

  /// Adds a sample. `counting`: the path is counted, from the first puncture of the skin until access.
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
  std::array<Place, 128> recent_;  ///< ring buffer; holds more than kSpeed_us at 1 kHz
  std::size_t begin_ = 0, size_ = 0;
  Movements translations_{50}, rotations_{50};  ///< limits in mm/s and deg/s
  double forceSum_N_ = 0, forceMax_N_ = 0;
  std::int64_t pressed_ = 0;
};

}  // namespace insonate::metrics
