#pragma once

#include "../feature/Feature.h"

namespace insonate::prepare {

/// The feature for a vessel: its straightened view and its cross-sections, in place of the lower views.
class VesselFeature final : public Feature {
 public:
  VesselFeature(PrepareModel& model, PrepareLayout& layout);
};

}  // namespace insonate::prepare
