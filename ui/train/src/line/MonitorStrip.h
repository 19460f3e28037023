#pragma once

#include <insonate/simulator/Electrocardiogram.h>

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <optional>

class QLabel;

namespace insonate::ui {
class Workspace;
}

namespace insonate::train {

class AttemptControl;
class EcgTrace;
struct TrainModel;

/// The patient monitor above the patient in 3D: ECG, heart rate, blood pressure, and the name of an abnormal rhythm.
/// While the sound of the window is on, each beat is a beep; that of an extra beat is lower. Visible during an attempt
/// at a procedure with a line, since a wire in the heart is first seen here.
class MonitorStrip final : public QWidget {
  Q_OBJECT

 public:
  MonitorStrip(TrainModel& model, AttemptControl& attempt, ui::Workspace& workspace);

 protected:
  /// A maximized view shows all widgets again that it had hidden; meanwhile the attempt may have ended.
  void showEvent(QShowEvent* event) override;

 private:
  void followImage();
  void tick();
  void beep(double now_s);
  double now_s() const;
  void refresh();

  TrainModel& model_;
  AttemptControl& attempt_;
  ui::Workspace& workspace_;
  Electrocardiogram ecg_;
  double beeped_s_ = 0;  ///< time up to which beats have beeped
  EcgTrace* trace_;
  QLabel *rate_, *pressure_, *rhythm_;
  QTimer timer_;
  QElapsedTimer clock_;
  std::optional<double> ahead_s_;  ///< time of the patient's pulse less that of clock_; empty before the first image
};

}  // namespace insonate::train
