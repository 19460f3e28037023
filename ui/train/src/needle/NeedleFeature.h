#pragma once

#include "../feature/Feature.h"

class QAction;

namespace insonate::train {

/// The needle moved by keys and numbers.
class NeedleFeature final : public Feature {
  Q_OBJECT

 public:
  /// `showDevices`: the action of the button beside the needle's heading.
  NeedleFeature(TrainModel& model, TrainLayout& layout, QAction& showDevices);

  void act(const KeyRow& row, KeyPress press) override;
};

}  // namespace insonate::train
