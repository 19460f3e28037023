#pragma once

#include "../feature/Feature.h"

namespace insonate::prepare {

/// The feature for the table of structures: names, states and appearance, and the keys for the selected structure.
class StructuresFeature final : public Feature {
 public:
  StructuresFeature(PrepareModel& model, PrepareLayout& layout);

  void save(QSettings& settings) const override;
  void restore(QSettings& settings) override;

 private:
  void addCommands();
  void toggleVisible();
  void toggleLocked();
  void refreshMark();
};

}  // namespace insonate::prepare
