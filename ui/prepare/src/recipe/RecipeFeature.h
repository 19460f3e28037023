#pragma once

#include "../feature/Feature.h"

namespace insonate::prepare {

/// The feature for the steps of labeling so far, which can be saved and replayed.
class RecipeFeature final : public Feature {
 public:
  RecipeFeature(PrepareModel& model, PrepareLayout& layout);
};

}  // namespace insonate::prepare
