#pragma once

#include "../feature/Feature.h"

namespace insonate::prepare {

/// The feature for the display of slices: window and level of the CT, and the labels over the CT.
class SlicesFeature final : public Feature {
 public:
  SlicesFeature(PrepareModel& model, PrepareLayout& layout);

  void save(QSettings& settings) const override;
  void restore(QSettings& settings) override;
};

}  // namespace insonate::prepare
