#pragma once

#include "../feature/Feature.h"

namespace insonate::prepare {

/// The feature for the sizes of columns and views, and for the list of the views' own keys and gestures.
class LayoutFeature final : public Feature {
 public:
  LayoutFeature(PrepareModel& model, PrepareLayout& layout);

  void save(QSettings& settings) const override;
  void restore(QSettings& settings) override;
};

}  // namespace insonate::prepare
