#include "NeedleFeature.h"

#include "../layout/ControlsColumn.h"
#include "../layout/TrainLayout.h"
#include "../model/TrainModel.h"
#include "NeedleControls.h"

#include <QAction>

namespace insonate::train {

NeedleFeature::NeedleFeature(TrainModel& model, TrainLayout& layout, QAction& showDevices)
    : Feature(model, layout, {Command::TakeNeedle, Command::MoveNeedle}) {
  auto* controls = new NeedleControls(model.status, model.disclosure, model.hands, model.motion, model.needle);
  layout.controls().addSection(controls);
  connect(controls, &NeedleControls::devicesWanted, &showDevices, &QAction::trigger);
}

void NeedleFeature::act(const KeyRow& row, KeyPress press) {
  if (row.command == Command::MoveNeedle) return model_.needle.move(row.needle, press.wide ? row.wide : row.step);
  if (!press.repeated) model_.needle.toggle();
}

}  // namespace insonate::train
