#pragma once

#include "../feature/Feature.h"

namespace insonate::train {

class TissueShown;

/// The feature for the tissue under the probe: its model, the patient's blood pressure and posture, and the display of
/// its mechanics.
class TissueFeature final : public Feature {
  Q_OBJECT

 public:
  TissueFeature(TrainModel& model, TrainLayout& layout);

  void save(QSettings& settings) const override;
  void restore(QSettings& settings) override;

 private:
  void addCommands();

  TissueShown* shown_ = nullptr;
};

}  // namespace insonate::train
