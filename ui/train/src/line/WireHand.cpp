#include "WireHand.h"

#include "../model/HapticControl.h"

#include <insonate/simulator/HapticSession.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace insonate::train {
namespace {

/// Smaller motions are those of a hand at rest.
constexpr double kLeast_mm = 0.5;
constexpr int kLook_ms = 16;

}  // namespace

double GrippedWay::dueFor(double hand_mm) const {
  const double by_mm = hand_mm < gone_mm_ ? hand_mm - gone_mm_ : std::max(0.0, hand_mm - pushed_mm_);
  return std::abs(by_mm) < kLeast_mm ? 0 : by_mm;
}

void GrippedWay::moved(double by_mm, double gone_mm) {
  const bool isStopped = by_mm > 0 && gone_mm < by_mm - kLeast_mm;
  pushed_mm_ = isStopped ? std::max(gone_mm_, pushed_mm_) + by_mm : gone_mm_ + gone_mm;
  gone_mm_ += gone_mm;
}

WireHand::WireHand(HapticControl& hands, Move move, Resistance resistance, QObject* parent)
    : QObject(parent), hands_(hands), move_(std::move(move)), resistance_N_(std::move(resistance)) {
  timer_.setInterval(kLook_ms);
  connect(&timer_, &QTimer::timeout, this, [this] { look(); });
}

bool WireHand::canGrip() const {
  const HapticSession& session = hands_.session();
  return session.assignedDevice(kNeedleTool) && !session.followsMouse(kNeedleTool);
}

void WireHand::take(Instrument instrument) {
  if (!canGrip()) instrument = Instrument::Needle;
  if (std::exchange(instrument_, instrument) == instrument) return;
  isGripped_ = false;
  const bool isInstrument = instrument != Instrument::Needle;
  if (isInstrument) hands_.session().setFreeHand(FreeHand::Free);
  hands_.setInstrumentInHand(isInstrument);
  if (!isInstrument) hands_.session().setFreeHand(FreeHand::AtNeedle);
  isInstrument ? timer_.start() : timer_.stop();
}

void WireHand::look() {
  const ServoSnapshot now = hands_.session().snapshot();
  const bool isDown = now.present[kNeedleTool] && (now.states[kNeedleTool].buttons & kGripButton);
  if (std::exchange(isGripped_, isDown) != isDown) {
    way_ = {};
    hands_.session().setFreeHand(isDown ? FreeHand::AtWire : FreeHand::Free);
    return;  // the servo counts from its next tick on
  }
  if (!isDown) return;
  const double due_mm = way_.dueFor(now.output.wireHand_mm);
  if (due_mm == 0) return;
  way_.moved(due_mm, move_(instrument_, due_mm));
  const double resistance_N = instrument_ == Instrument::Wire ? std::max(0.0, resistance_N_()) : 0;
  hands_.session().setFreeHand(FreeHand::AtWire, {.gone_mm = way_.gone_mm(), .resistance_N = resistance_N});
}

}  // namespace insonate::train
