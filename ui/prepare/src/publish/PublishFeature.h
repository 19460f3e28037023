#pragma once

#include "../feature/Feature.h"

namespace insonate::prepare {

/// The feature for the last step, which publishes the saved case for trainees.
class PublishFeature final : public Feature {
 public:
  PublishFeature(PrepareModel& model, PrepareLayout& layout);
};

}  // namespace insonate::prepare
