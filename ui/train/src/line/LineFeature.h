#pragma once

#include "../feature/Feature.h"

namespace insonate::train {

class AttemptControl;
class LineStrip;

/// The feature for wire, dilator and catheter: the strip under the image, and the keys.
class LineFeature final : public Feature {
  Q_OBJECT

 public:
  LineFeature(TrainModel& model, TrainLayout& layout, AttemptControl& attempt);

 private:
  LineStrip* strip_ = nullptr;
};

}  // namespace insonate::train
