// The part of the workspace that measures how fast it is.
#include "PrepareParts.h"
#include "measure/LabellingMeasure.h"

namespace insonate::prepare {

void PrepareWorkspace::Parts::measureLabelling(int repeats, std::function<void(std::vector<LabellingTime>)> done) {
  measure_ = std::make_unique<LabellingMeasure>(shared, *tools_, *views, repeats, std::move(done));
}

}  // namespace insonate::prepare
