#pragma once

#include "../feature/Feature.h"

namespace insonate::prepare {

/// The feature for targets, vessels, landmarks and start poses.
class PlacesFeature final : public Feature {
 public:
  PlacesFeature(PrepareModel& model, PrepareLayout& layout);
};

}  // namespace insonate::prepare
