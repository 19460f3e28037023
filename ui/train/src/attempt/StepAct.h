#pragma once

#include <insonate/simulator/NeedlePlacement.h>

#include <QString>
#include <optional>

namespace insonate {
struct AttemptView;
struct Procedure;
}  // namespace insonate

namespace insonate::ui {
class Commands;
}

namespace insonate::train {

class HapticControl;
class LiveModel;

/// State of probe, needle and pedal, which determines the trainee's next action.
struct HandsNow {
  bool isProbeInDevice = false;   ///< true: a device moves the probe; mouse and keys do not
  bool isNeedleInDevice = false;  ///< true: a device is chosen for the needle; mouse and keys do not move the needle
  bool hasNeedle = false;         ///< true: the user holds a needle
  bool hasPedal = false;          ///< true: a pedal is chosen and connected
  bool isAspirating = false, isFrozen = false, isColorOn = false;
  bool isInstrumentInHand = false;           ///< true: the device of the needle moves wire, dilator or catheter
  NeedlePlane plane = NeedlePlane::InPlane;  ///< plane in which mouse and keys take the needle
  /// Angle between skin and needle; empty: the needle cannot be turned by mouse and keys now.
  std::optional<double> angle_deg;
  bool canTurnNeedle = false;  ///< true: mouse and keys can turn the needle about its entry point
};
HandsNow handsNow(HapticControl& hands, const LiveModel& live, bool isAspirating);

/// The trainee's next action in an attempt.
struct StepAct {
  QString words;    ///< one sentence with the key and the control: "Aspirate: press B, or click Aspirate."
  QString control;  ///< object name of the control; empty: the window has no control for the action
};

/// Returns the action that leads to the step that is due, or that finishes the attempt if no step is due.
StepAct nextAct(const Procedure& procedure, const AttemptView& view, const HandsNow& hands,
                const ui::Commands& commands);

}  // namespace insonate::train
