#pragma once

#include <insonate/simulator/Electrocardiogram.h>

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <optional>

class QLabel;

namespace insonate::train {

class AttemptControl;
class EcgTrace;
struct TrainModel;

/// The patient monitor under the image: ECG, heart rate, blood pressure, and the name of an abnormal rhythm. Visible
/// during an attempt at a procedure with a line, since a wire in the heart is first seen here.
class MonitorStrip final : public QWidget {
  Q_OBJECT

 public:
  MonitorStrip(TrainModel& model, AttemptControl& attempt, QWidget* parent = nullptr);

 private:
  void followImage();
  void tick();
  double now_s() const;
  void refresh();

  TrainModel& model_;
  AttemptControl& attempt_;
  Electrocardiogram ecg_;
  EcgTrace* trace_;
  QLabel *rate_, *pressure_, *rhythm_;
  QTimer timer_;
  QElapsedTimer clock_;
  std::optional<double> ahead_s_;  ///< time of the patient's pulse less that of clock_; empty before the first image
};

}  // namespace insonate::train
