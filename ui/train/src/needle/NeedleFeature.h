#pragma once

#include "../feature/Feature.h"

class QAction;

namespace insonate::train {

/// The feature for moving the needle by keys and numbers.
class NeedleFeature final : public Feature {
  Q_OBJECT

 public:
  /// `showDevices`: action of the button beside the section's heading.
  NeedleFeature(TrainModel& model, TrainLayout& layout, QAction& showDevices);

  void act(const KeyRow& row, KeyPress press) override;
};

}  // namespace insonate::train
