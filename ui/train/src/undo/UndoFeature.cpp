#include "UndoFeature.h"

#include "../layout/TrainLayout.h"
#include "../model/TrainModel.h"

namespace insonate::train {

UndoFeature::UndoFeature(TrainModel& model, TrainLayout& layout) : Feature(model, layout) {
  const auto isAvailable = [this] { return !layout_.isPageShown(); };
  beginSection(KeySection::Undo);
  addCommand({.id = "train.undo.undo",
              .text = {},
              .does = tr("undoes the last change (movement, setting or deletion)"),
              .listed = tr("Ctrl+Z, Z"),
              .keys = {{Qt::Key_Z, Qt::ControlModifier, {}}, {Qt::Key_Z, {}, {}}},
              .perform = [this](ui::KeyPress) { undoStep(model_.history, model_.status); },
              .isAvailable = isAvailable});
  addCommand({.id = "train.undo.redo",
              .text = {},
              .does = tr("redoes the last undone change"),
              .listed = tr("Ctrl+Y, Y"),
              .keys = {{Qt::Key_Y, Qt::ControlModifier, {}}, {Qt::Key_Y, {}, {}}},
              .perform = [this](ui::KeyPress) { redoStep(model_.history, model_.status); },
              .isAvailable = isAvailable});
}

}  // namespace insonate::train
