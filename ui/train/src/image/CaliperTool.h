#pragma once

#include <insonate/views/Caliper.h>

#include <optional>
#include <vector>

namespace insonate::train {

/// Places calipers point by point, by clicks or by dragging from one point to the next.
class CaliperTool {
 public:
  /// Sets the kind of caliper that the next mouse press begins; empty: no measurement. Discards an incomplete caliper.
  void setKind(std::optional<views::CaliperKind> kind);
  std::optional<views::CaliperKind> kind() const { return kind_; }

  void pressed(views::ImagePoint at);
  void moved(views::ImagePoint at);
  void released(views::ImagePoint at);
  void clear();

  /// Returns the complete calipers, followed by the caliper that is being placed.
  std::vector<views::Caliper> calipers() const;
  const std::vector<views::Caliper>& done() const { return done_; }
  /// Replaces all complete calipers, and discards the caliper that is being placed.
  void setDone(std::vector<views::Caliper> calipers);
  bool placing() const { return fixed_ > 0; }

 private:
  void fix();

  std::optional<views::CaliperKind> kind_;
  std::vector<views::Caliper> done_;
  views::Caliper open_;
  int fixed_ = 0;  ///< number of points of open_ that are already placed; 0: no caliper was begun
};

}  // namespace insonate::train
