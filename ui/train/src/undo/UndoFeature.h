#pragma once

#include "../feature/Feature.h"

namespace insonate::train {

/// The feature for the keys of undo and redo. The keys work even without a patient, since a probe can be edited without
/// a patient.
class UndoFeature final : public Feature {
  Q_OBJECT

 public:
  UndoFeature(TrainModel& model, TrainLayout& layout);
};

}  // namespace insonate::train
