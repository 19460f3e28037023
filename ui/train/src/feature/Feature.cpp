#include "Feature.h"

#include "../layout/TrainLayout.h"
#include "../model/TrainModel.h"

#include <algorithm>

namespace insonate::train {

Feature::Feature(TrainModel& model, TrainLayout& layout, std::initializer_list<Command> commands)
    : QObject(&layout.workspace()), model_(model), layout_(layout), commands_(commands) {}

bool Feature::takes(Command command) const {
  return std::ranges::find(commands_, command) != commands_.end() && isAvailable(command);
}

bool Feature::isAvailable(Command) const {
  return model_.patientCase.patient() && !layout_.isPageShown();
}

}  // namespace insonate::train
