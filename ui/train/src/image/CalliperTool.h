#pragma once

#include <insonate/views/Calliper.h>

#include <optional>
#include <vector>

namespace insonate::train {

/// Places calipers point by point, by clicks or by dragging from one point to the next.
class CalliperTool {
 public:
  /// Sets the kind of caliper that the next mouse press begins; empty: no measurement. Discards an incomplete caliper.
  void setKind(std::optional<views::CalliperKind> kind);
  std::optional<views::CalliperKind> kind() const { return kind_; }

  void pressed(views::PicturePoint at);
  void moved(views::PicturePoint at);
  void released(views::PicturePoint at);
  void clear();

  /// Returns the complete calipers, followed by the caliper that is being placed.
  std::vector<views::Calliper> callipers() const;
  const std::vector<views::Calliper>& done() const { return done_; }
  /// Replaces all complete calipers, and discards the caliper that is being placed.
  void setDone(std::vector<views::Calliper> callipers);
  bool placing() const { return fixed_ > 0; }

 private:
  void fix();

  std::optional<views::CalliperKind> kind_;
  std::vector<views::Calliper> done_;
  views::Calliper open_;
  int fixed_ = 0;  ///< number of points of open_ that are already placed; 0: no caliper was begun
};

}  // namespace insonate::train
