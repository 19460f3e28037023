#pragma once

#include <insonate/haptics/HapticServo.h>
#include <insonate/procedure/LineInstruments.h>

#include <QObject>
#include <QTimer>
#include <cstdint>
#include <functional>

namespace insonate::train {

class HapticControl;

/// Way of an instrument behind the hand that grips it. A hand that pushes on against a stop does not move the
/// instrument; when the hand comes back, the instrument stays until the hand is behind it.
class GrippedWay {
 public:
  /// Returns the distance by which the instrument has to be moved for a hand at this place, both counted from the grip;
  /// 0: it stays.
  double dueFor(double hand_mm) const;
  /// Tells what came of moving it by `by_mm`: the distance that it has gone.
  void moved(double by_mm, double gone_mm);
  double gone_mm() const { return gone_mm_; }

 private:
  double gone_mm_ = 0;
  double pushed_mm_ = 0;  ///< place up to which the hand has pushed against a stop; gone_mm_ without a stop
};

/// Moves wire, dilator or catheter with the device of the needle, 1:1: while the second button of the device is held,
/// the hand grips the instrument; without the button, the hand moves back freely for the next grip. The needle stays in
/// its place. The hand feels the resistance of the instrument.
class WireHand final : public QObject {
  Q_OBJECT

 public:
  /// Moves the instrument; returns the distance that it has gone.
  using Move = std::function<double(Instrument instrument, double by_mm)>;
  using Resistance = std::function<double()>;
  WireHand(HapticControl& hands, Move move, Resistance resistance, QObject* parent);

  /// Tells whether a device that can grip an instrument moves the needle.
  bool canGrip() const;
  /// Puts an instrument into the hand; Instrument::Needle: the device moves the needle again.
  void take(Instrument instrument);
  Instrument instrument() const { return instrument_; }

 private:
  void look();

  HapticControl& hands_;
  Move move_;
  Resistance resistance_N_;
  Instrument instrument_ = Instrument::Needle;
  bool isGripped_ = false;
  GrippedWay way_;
  QTimer timer_;
};

}  // namespace insonate::train
