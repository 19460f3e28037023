#pragma once

#include "../feature/Feature.h"

#include <insonate/views/UltrasoundView.h>

#include <memory>

namespace insonate {
struct LiveFrame;
}
namespace insonate::ui {
class ViewWidget;
}

namespace insonate::review {

class AttemptPage;
class Timeline;

/// Replay of the open attempt: moments, the ultrasound image of the present time, transport and timeline.
class ReplayFeature final : public Feature {
 public:
  ReplayFeature(const ReviewModel& model, AttemptPage& page);

  /// Shows the image in the center.
  void showImage();
  Timeline& timeline() { return *timeline_; }

 private:
  void addCommands();
  void addTimeCommands();
  void changeSpeed(int by);
  QString imageWords() const;
  void showFrame();
  void showFieldOfView(const LiveFrame& frame);

  AttemptPage& page_;
  std::shared_ptr<views::UltrasoundView> view_;
  std::shared_ptr<const LiveFrame> shown_;
  ui::ViewWidget* image_;
  Timeline* timeline_;
};

}  // namespace insonate::review
