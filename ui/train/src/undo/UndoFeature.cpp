#include "UndoFeature.h"

#include "../layout/TrainLayout.h"
#include "../model/TrainModel.h"

namespace insonate::train {

UndoFeature::UndoFeature(TrainModel& model, TrainLayout& layout)
    : Feature(model, layout, {Command::Undo, Command::Redo}) {}

void UndoFeature::act(const KeyRow& row, KeyPress) {
  row.command == Command::Undo ? undoStep(model_.history, model_.status) : redoStep(model_.history, model_.status);
}

bool UndoFeature::isAvailable(Command) const {
  return !layout_.isPageShown();
}

}  // namespace insonate::train
