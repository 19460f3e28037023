#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace insonate::train {

class TrainSession;

/// A press key that is held down: a step at once, then, after a moment, smoothly on until a key comes up, whoever has
/// the keyboard by then.
class HeldPress final : public QObject {
 public:
  static constexpr int kBegins_ms = 250;
  static constexpr double kSpeed_mmPerS = 4;

  explicit HeldPress(TrainSession& session, QObject* parent = nullptr);

  /// `step_mm` below 0 lets go.
  void begin(double step_mm);
  void end();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void goOn();

  TrainSession& session_;
  QTimer timer_;
  QElapsedTimer clock_;
  double direction_ = 1, told_s_ = 0;
};

}  // namespace insonate::train
