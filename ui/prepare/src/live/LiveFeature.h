#pragma once

#include "../feature/Feature.h"

namespace insonate::prepare {

/// The feature for the small ultrasound image of the labels.
class LiveFeature final : public Feature {
 public:
  LiveFeature(PrepareModel& model, PrepareLayout& layout);

  QString engineText() const override;
};

}  // namespace insonate::prepare
