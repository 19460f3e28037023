#include "GamepadMap.h"

#include <insonate/ui/Text.h>

#include <QSettings>
#include <QVariantList>

namespace insonate::train {

double GamepadMap::valueOf(GamepadFunction function, const GamepadReading& reading) const {
  const int control = controlOf(function);
  if (control >= kGamepadAxes) return reading.isDown(GamepadButton(control - kGamepadAxes)) ? 1 : 0;
  const auto axis = GamepadAxis(control);
  const bool isUpright = axis == GamepadAxis::LeftY || axis == GamepadAxis::RightY;
  return isUpright ? -reading.of(axis) : reading.of(axis);
}

void GamepadMap::save(QSettings& settings) const {
  QVariantList list;
  for (const int control : controls_) list << control;
  settings.setValue("controllerMap", list);
}

void GamepadMap::restore(QSettings& settings) {
  const QVariantList list = settings.value("controllerMap").toList();
  if (list.size() != kGamepadFunctions) return;
  for (int n = 0; n < kGamepadFunctions; ++n)
    if (const int control = list[n].toInt(); control >= 0 && control < kGamepadAxes + kGamepadButtons)
      controls_[std::size_t(n)] = control;
}

QString nameOfFunction(GamepadFunction function) {
  static const char* const kNames[kGamepadFunctions] = {"left hand: slides along the image",
                                                        "left hand: slides across the image",
                                                        "left hand: presses the probe, or advances the needle",
                                                        "left hand, while held: turns and tilts, withdraws the needle",
                                                        "right hand: slides along the image",
                                                        "right hand: slides across the image",
                                                        "right hand: presses the probe, or advances the needle",
                                                        "right hand, while held: turns and tilts, withdraws the needle",
                                                        "takes up the needle, or puts it away",
                                                        "freezes or unfreezes the image",
                                                        "aspirates while held",
                                                        "moves the probe to its start"};
  return tr(kNames[int(function)]);
}

QString nameOfControl(int control) {
  static const char* const kNames[kGamepadAxes + kGamepadButtons] = {"left stick, sideways",
                                                                     "left stick, up and down",
                                                                     "right stick, sideways",
                                                                     "right stick, up and down",
                                                                     "left trigger",
                                                                     "right trigger",
                                                                     "lower button (A)",
                                                                     "right button (B)",
                                                                     "left button (X)",
                                                                     "upper button (Y)",
                                                                     "Back",
                                                                     "Guide",
                                                                     "Start",
                                                                     "left stick, pressed",
                                                                     "right stick, pressed",
                                                                     "left shoulder",
                                                                     "right shoulder",
                                                                     "pad, up",
                                                                     "pad, down",
                                                                     "pad, left",
                                                                     "pad, right"};
  return tr(kNames[control]);
}

}  // namespace insonate::train
