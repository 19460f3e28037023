#include "LabelingMeasure.h"

#include <insonate/prepare/PrepareBenchmark.h>

#include <utility>

namespace insonate::prepare {

PrepareBenchmark::PrepareBenchmark(PrepareModel& model, ToolSession& tools, CaseViews& views)
    : model_(model), tools_(tools), views_(views) {}

PrepareBenchmark::~PrepareBenchmark() = default;

void PrepareBenchmark::measureLabeling(int repeats, std::function<void(std::vector<LabelingTime>)> done) {
  labeling_ = std::make_unique<LabelingMeasure>(model_, tools_, views_, repeats, std::move(done));
}

}  // namespace insonate::prepare
