#pragma once

#include "../feature/Feature.h"
#include "../model/HapticControl.h"

class QAction;

namespace insonate::train {

/// The feature for moving the needle by keys and numbers.
class NeedleFeature final : public Feature {
  Q_OBJECT

 public:
  /// `showDevices`: action of the button beside the section's heading.
  NeedleFeature(TrainModel& model, TrainLayout& layout, QAction& showDevices);

 private:
  void addCommands();
  void addMoves();
  ui::CommandKey moveKey(int key, NeedleAxis axis, double step, double wide, Qt::KeyboardModifiers modifiers) const;
};

}  // namespace insonate::train
