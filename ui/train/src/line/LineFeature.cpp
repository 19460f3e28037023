#include "LineFeature.h"

#include "../attempt/AttemptControl.h"
#include "../layout/ImageColumn.h"
#include "../layout/TrainLayout.h"
#include "../model/TrainModel.h"
#include "LineStrip.h"
#include "MonitorStrip.h"

#include <insonate/ui/Workspace.h>

namespace insonate::train {

LineFeature::LineFeature(TrainModel& model, TrainLayout& layout, AttemptControl& attempt) : Feature(model, layout) {
  beginSection(KeySection::Attempts);
  const auto isLine = [this, &attempt] {
    return isPatientShown() && attempt.isRunning() && hasLine(attempt.procedure());
  };
  addCommand({.id = "train.line.acts",
              .text = {},
              .does = tr("opens the menu of acts: preparation, hub, wire, catheter"),
              .listed = tr("G"),
              .keys = keys({Qt::Key_G}),
              .perform = once([this] { strip_->openActs(); }),
              .isAvailable = isLine});
  addCommand(
      {.id = "train.line.instrument",
       .text = {},
       .does = tr("chooses the next instrument: wire, dilator or catheter; with a haptic device also the needle"),
       .listed = tr("R"),
       .keys = keys({Qt::Key_R}),
       .perform = once([this] { strip_->chooseNext(); }),
       .isAvailable = isLine});
  const auto moveKey = [this](int key, double by_mm) {
    return ui::CommandKey{key, Qt::ControlModifier, [this, by_mm](ui::KeyPress press) {
                            strip_->move(press.wide ? 4 * by_mm : by_mm, press.repeated);
                          }};
  };
  addCommand({.id = "train.line.move",
              .text = {},
              .does = tr("advances or withdraws the chosen instrument by 5 mm (with Shift: 20 mm)"),
              .listed = tr("Ctrl+Page Down, Ctrl+Page Up"),
              .keys = {moveKey(Qt::Key_PageDown, 5), moveKey(Qt::Key_PageUp, -5)},
              .perform = {},
              .isAvailable = isLine});
  strip_ = new LineStrip(attempt, model.hands, commands(), &layout.image());
  layout.image().add(ImageColumn::Line, strip_);
  // Not under the image, which needs the height.
  layout.addAbovePatient(new MonitorStrip(model, attempt, layout.workspace()));
}

}  // namespace insonate::train
