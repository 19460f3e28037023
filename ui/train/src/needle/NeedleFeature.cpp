#include "NeedleFeature.h"

#include "../layout/ControlsColumn.h"
#include "../layout/ImageColumn.h"
#include "../layout/TrainLayout.h"
#include "../model/TrainModel.h"
#include "NeedleControls.h"
#include "NeedleStrip.h"

#include <QAction>

namespace insonate::train {

NeedleFeature::NeedleFeature(TrainModel& model, TrainLayout& layout, QAction& showDevices) : Feature(model, layout) {
  addCommands();
  auto* controls =
      new NeedleControls(model.status, model.disclosure, model.hands, model.motion, model.needle, commands());
  controls->setShowDevices(showDevices);
  layout.controls().addSection(controls);
  layout.image().add(ImageColumn::Line,
                     new NeedleStrip(model.hands, model.needle, model.tray, commands(), &layout.image()));
}

void NeedleFeature::addCommands() {
  beginSection(KeySection::Needle);
  addCommand({.id = "train.needle.take",
              .text = {},
              .does = tr("takes up the needle beside the probe, or puts the needle away"),
              .listed = tr("I"),
              .keys = keys({Qt::Key_I}),
              .perform = once([this] { model_.needle.toggle(); })});
  addMoves();
  commands().addListed(tr("Shift+wheel on image or 3D view"), tr("advances or withdraws the needle"));
}

void NeedleFeature::addMoves() {
  using enum NeedleAxis;
  addCommand({.id = "train.needle.advance",
              .text = {},
              .does = tr("advances or withdraws the needle by 1 mm (with Shift: 5 mm)"),
              .listed = tr("Page Down, Page Up"),
              .keys = {moveKey(Qt::Key_PageDown, Advance, 1, 5, {}), moveKey(Qt::Key_PageUp, Advance, -1, -5, {})},
              .perform = {}});
  // Alt with the probe's keys moves the needle.
  const auto alt = [this](int key, NeedleAxis axis, double step, double wide) {
    return moveKey(key, axis, step, wide, Qt::AltModifier);
  };
  addCommand({.id = "train.needle.entry",
              .text = {},
              .does = tr("slides the entry point of the needle over the skin by 1 mm (with Shift: 5 mm)"),
              .listed = tr("Alt+arrows"),
              .keys = {alt(Qt::Key_Left, Lateral, -1, -5), alt(Qt::Key_Right, Lateral, 1, 5),
                       alt(Qt::Key_Up, Elevation, -1, -5), alt(Qt::Key_Down, Elevation, 1, 5)},
              .perform = {}});
  addCommand({.id = "train.needle.heading",
              .text = {},
              .does = tr("changes the heading of the needle on the skin by 2 degrees (with Shift: 10 degrees)"),
              .listed = tr("Alt+Q, Alt+E"),
              .keys = {alt(Qt::Key_Q, Heading, -2, -10), alt(Qt::Key_E, Heading, 2, 10)},
              .perform = {}});
  addCommand({.id = "train.needle.angle",
              .text = {},
              .does = tr("makes the needle steeper or flatter by 1 degree (with Shift: 5 degrees)"),
              .listed = tr("Alt+W, Alt+S"),
              .keys = {alt(Qt::Key_W, Angle, 1, 5), alt(Qt::Key_S, Angle, -1, -5)},
              .perform = {}});
  addCommand({.id = "train.needle.bevel",
              .text = {},
              .does = tr("rotates the bevel of the needle by 10 degrees (with Shift: 90 degrees)"),
              .listed = tr("Alt+A, Alt+D"),
              .keys = {alt(Qt::Key_A, Bevel, -10, -90), alt(Qt::Key_D, Bevel, 10, 90)},
              .perform = {}});
}

/// Key that moves the needle in mm or degrees.
ui::CommandKey NeedleFeature::moveKey(int key, NeedleAxis axis, double step, double wide,
                                      Qt::KeyboardModifiers modifiers) const {
  return {key, modifiers,
          [this, axis, step, wide](ui::KeyPress press) { model_.needle.move(axis, press.wide ? wide : step); }};
}

}  // namespace insonate::train
