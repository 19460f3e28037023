#pragma once

#include "../feature/Feature.h"

namespace insonate::train {

/// The feature for color Doppler: its controls, its command, and the color box on the image.
class DopplerFeature final : public Feature {
  Q_OBJECT

 public:
  DopplerFeature(TrainModel& model, TrainLayout& layout);

  void save(QSettings& settings) const override;
  void restore(QSettings& settings) override;
};

}  // namespace insonate::train
