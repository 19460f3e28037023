#pragma once

#include <insonate/views/Calliper.h>

#include <optional>
#include <vector>

namespace insonate::train {

/// Places calipers point by point, by clicks or by dragging from one point to the next.
class CalliperTool {
 public:
  /// The kind that the next press begins; none to stop measuring. A caliper that is not complete is dropped.
  void setKind(std::optional<views::CalliperKind> kind);
  std::optional<views::CalliperKind> kind() const { return kind_; }

  void pressed(views::PicturePoint at);
  void moved(views::PicturePoint at);
  void released(views::PicturePoint at);
  void clear();

  /// The complete ones, and last the one being placed.
  std::vector<views::Calliper> callipers() const;
  const std::vector<views::Calliper>& done() const { return done_; }
  /// Instead of all there are; one that is being placed is dropped.
  void setDone(std::vector<views::Calliper> callipers);
  bool placing() const { return fixed_ > 0; }

 private:
  void fix();

  std::optional<views::CalliperKind> kind_;
  std::vector<views::Calliper> done_;
  views::Calliper open_;
  int fixed_ = 0;  ///< points of open_ that stay; 0: none begun
};

}  // namespace insonate::train
