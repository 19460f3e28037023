#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

class QSettings;

namespace insonate {
struct NeedleEvent;
}

namespace insonate::train {

struct TrainModel;
class TrainLayout;

/// Sight and sound in place of force, for hands that feel none: a strip at the lower edge of the image shows the
/// pressure of the probe and the resistance to the needle, and each puncture makes a soft click. Captions name the
/// clicks while the sound is on. Off at first.
class ForceCues final : public QWidget {
  Q_OBJECT

 public:
  ForceCues(TrainModel& model, TrainLayout& layout);

  bool isOn() const { return isOn_; }
  void setOn(bool isOn);
  /// Caption of the last click; empty after a moment.
  const QString& caption() const { return caption_; }

  void save(QSettings& settings) const;
  void restore(QSettings& settings);
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void look();
  void click(const NeedleEvent& event);

  TrainModel& model_;
  TrainLayout& layout_;
  bool isOn_ = false;
  double probe_N_ = 0, needle_N_ = 0;
  QString caption_;
  QElapsedTimer sinceClick_;
  QTimer timer_;
};

}  // namespace insonate::train
