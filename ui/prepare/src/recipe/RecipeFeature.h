#pragma once

#include "../feature/Feature.h"

namespace insonate::prepare {

/// The feature for recipes: the user can save the labeling steps so far and replay them.
class RecipeFeature final : public Feature {
 public:
  RecipeFeature(PrepareModel& model, PrepareLayout& layout);
};

}  // namespace insonate::prepare
