#pragma once

#include <insonate/simulator/NeedleHand.h>

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

class HandsControl;
class LiveModel;

/// State of the hands, from which the next act follows.
struct HandsNow {
  bool isProbeInDevice = false;   ///< a device moves the probe; mouse and keys do not
  bool isNeedleInDevice = false;  ///< a device is chosen for the needle; mouse and keys do not move it
  bool hasNeedle = false;         ///< a needle is in a hand
  bool hasPedal = false;          ///< a pedal is chosen and connected
  bool isAspirating = false, isFrozen = false;
  NeedlePlane plane = NeedlePlane::Along;  ///< in which mouse and keys take the needle
  /// Angle between skin and needle; empty: the needle cannot be turned by mouse and keys now.
  std::optional<double> angle_deg;
  bool canTurnNeedle = false;  ///< mouse and keys can turn the needle about its entry
};
HandsNow handsNow(HandsControl& hands, const LiveModel& live, bool isAspirating);

/// The act that comes next in an attempt.
struct StepAct {
  QString words;    ///< one sentence with the key and the control: "Aspirate: press B, or click Aspirate."
  QString control;  ///< object name of the control; empty: the window has no control for the act
};

/// Returns the act that leads to the due step, or that finishes the attempt if no step is due.
StepAct nextAct(const Procedure& procedure, const AttemptView& view, const HandsNow& hands,
                const ui::Commands& commands);

}  // namespace insonate::train
