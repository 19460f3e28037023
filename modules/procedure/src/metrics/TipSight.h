#pragma once

#include <cstdint>
#include <optional>

namespace insonate::metrics {

/// The share of a time in which the image shows the tip.
class TipSight {
 public:
  /// Adds a sample; the time since the previous sample counts if both samples count.
  void follow(std::int64_t time_us, bool counts, bool isShown) {
    if (counts && last_us_) {
      all_us_ += time_us - *last_us_;
      if (isShown) shown_us_ += time_us - *last_us_;
    }
    last_us_ = counts ? std::optional(time_us) : std::nullopt;
  }
  std::optional<double> percent() const {
    if (all_us_ == 0) return std::nullopt;
    return 100 * static_cast<double>(shown_us_) / static_cast<double>(all_us_);
  }

 private:
  std::optional<std::int64_t> last_us_;
  std::int64_t all_us_ = 0, shown_us_ = 0;
};

}  // namespace insonate::metrics
