#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace insonate::train {

class ProbeMotion;

/// Handles a key that compresses the tissue while the user holds the key down: one step at once and, after a moment,
/// continuous motion until a key is released, even if the keyboard focus has moved meanwhile.
class HeldPress final : public QObject {
 public:
  static constexpr int kBegins_ms = 250;
  static constexpr double kSpeed_mmPerS = 4;

  explicit HeldPress(ProbeMotion& motion, QObject* parent = nullptr);

  /// Begins to change the compression in steps of `step_mm`; below 0 the compression is reduced.
  void begin(double step_mm);
  void end();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void goOn();

  ProbeMotion& motion_;
  QTimer timer_;
  QElapsedTimer clock_;
  double direction_ = 1, told_s_ = 0;
};

}  // namespace insonate::train
