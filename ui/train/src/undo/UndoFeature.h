#pragma once

#include "../feature/Feature.h"

namespace insonate::train {

/// The feature for the keys of undo and redo. They work also without a patient, since a probe can be edited without
/// one.
class UndoFeature final : public Feature {
  Q_OBJECT

 public:
  UndoFeature(TrainModel& model, TrainLayout& layout);
};

}  // namespace insonate::train
