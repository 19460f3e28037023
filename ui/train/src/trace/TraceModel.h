#pragma once

#include <insonate/ultrasound/SpectralDoppler.h>

#include <QObject>

namespace insonate::train {

class ImagingModel;
class LiveModel;

/// Settings of the traces over time under the image: PW Doppler of a gate, and M-mode of a scanline. Both are off at
/// first. They do not change the image, and recordings of attempts do not contain them.
class TraceModel : public QObject {
  Q_OBJECT

 public:
  TraceModel(ImagingModel& imaging, LiveModel& live, QObject* parent = nullptr);

  bool isPwOn() const { return pwOn_; }
  void setPwOn(bool isOn);
  /// Settings of the gate, limited to what probe and depth permit. angle_deg is the absolute value of angle_deg().
  SpectralSettings gate() const;
  void setGate(const SpectralSettings& gate);
  /// Angle from the beam to the direction of flow in the image, -80 to 80; positive: toward +lateral.
  double angle_deg() const { return angle_deg_; }
  void setAngle(double angle_deg);
  GatePlace place() const;

  bool isMModeOn() const { return mModeOn_; }
  void setMModeOn(bool isOn);
  /// Scanline of M-mode, as a fraction of the field of view from its left edge.
  double line() const { return line_; }
  void setLine(double across);

  /// Duration that a trace shows, s, 2 to 12.
  double sweep_s() const { return sweep_s_; }
  void setSweep(double seconds);

 Q_SIGNALS:
  void changed();

 private:
  void send();

  ImagingModel& imaging_;
  LiveModel& live_;
  SpectralSettings gate_;
  double angle_deg_ = 0, line_ = 0.4, sweep_s_ = 5;
  bool pwOn_ = false, mModeOn_ = false;
};

}  // namespace insonate::train
