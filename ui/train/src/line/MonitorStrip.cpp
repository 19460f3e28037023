#include "MonitorStrip.h"

#include "../attempt/AttemptControl.h"
#include "../model/TrainModel.h"

#include <insonate/ui/Sound.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>
#include <insonate/ui/Workspace.h>
#include <insonate/views/Theme.h>

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace insonate::train {
namespace {

/// A tone of 70 ms that begins and ends softly.
std::vector<float> toneOf(double frequency_Hz) {
  constexpr double kLength_s = 0.07, kVolume = 0.3;
  std::vector<float> samples(static_cast<std::size_t>(kLength_s * ui::kSoundRate_Hz));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double time_s = static_cast<double>(i) / ui::kSoundRate_Hz;
    const double envelope = std::sin(std::numbers::pi * time_s / kLength_s);
    samples[i] =
        static_cast<float>(kVolume * envelope * envelope * std::sin(2 * std::numbers::pi * frequency_Hz * time_s));
  }
  return samples;
}

}  // namespace

/// The ECG's curve, which a bar sweeps from left to right, as on a patient monitor.
class EcgTrace final : public QWidget {
 public:
  explicit EcgTrace(const Electrocardiogram& ecg) : ecg_(ecg) {
    setObjectName("ecgTrace");
    setAccessibleName(MonitorStrip::tr("ECG"));
    setToolTip(MonitorStrip::tr("ECG, 25 mm/s. A wire that touches the heart causes extra beats: wide and early."));
    setMinimumSize(160, 44);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  }
  void setTime(double now_s) {
    now_s_ = now_s;
    update();
  }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    QPainter painter(this);
    painter.fillRect(rect(), ui::toQColor(views::theme::kBlack));
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(ui::toQColor(views::theme::kGood), 1.4));
    // The screen's 96 px per inch: 25 mm/s.
    constexpr double kSpeed_pxps = 94, kGap_px = 14, kMost_s = 5;
    const double length_px = std::min<double>(width(), kSpeed_pxps * kMost_s);
    const double newest_px = std::fmod(now_s_ * kSpeed_pxps, length_px);
    QPainterPath path;
    bool isOpen = false;
    for (double x = 0; x < length_px; x += 1) {
      const double age_px = newest_px - x + (x > newest_px ? length_px : 0);
      if (length_px - age_px < kGap_px) {
        isOpen = false;
        continue;
      }
      const double y = height() * 0.72 - ecg_.voltage_mV(now_s_ - age_px / kSpeed_pxps) * height() * 0.42;
      isOpen ? path.lineTo(x, y) : path.moveTo(x, y);
      isOpen = true;
    }
    painter.drawPath(path);
  }

 private:
  const Electrocardiogram& ecg_;
  double now_s_ = 0;
};

MonitorStrip::MonitorStrip(TrainModel& model, AttemptControl& attempt, ui::Workspace& workspace)
    : model_(model), attempt_(attempt), workspace_(workspace), trace_(new EcgTrace(ecg_)) {
  setObjectName("monitorStrip");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 4, 8, 4);
  row->setSpacing(8);
  row->addWidget(trace_, 1);
  const auto addNumber = [&](const char* object, const QString& toolTip, const QString& widest) {
    auto* label = new QLabel;
    label->setObjectName(QLatin1String(object));
    label->setToolTip(toolTip);
    label->setMinimumWidth(label->fontMetrics().horizontalAdvance(widest));
    row->addWidget(label);
    return label;
  };
  rhythm_ = addNumber("monitorRhythm", tr("Rhythm of the heart, if it is not normal"), {});
  ui::setRole(rhythm_, "warning");
  rate_ = addNumber("monitorRate", tr("Heart rate, beats per minute"), tr("HR 188"));
  pressure_ = addNumber("monitorPressure", tr("Blood pressure: systolic / diastolic, mmHg"), tr("188/188"));
  clock_.start();
  timer_.setInterval(40);
  connect(&timer_, &QTimer::timeout, this, [this] { tick(); });
  connect(&model_.live, &LiveModel::pictureShown, this, [this] { followImage(); });
  connect(&attempt_, &AttemptControl::stateChanged, this, [this] { refresh(); });
  refresh();
}

double MonitorStrip::now_s() const {
  return static_cast<double>(clock_.elapsed()) * 1e-3 + ahead_s_.value_or(0);
}

/// An image shows the pulse of a moment that is past by the time of computing it; the ECG goes on while imaging is
/// frozen.
void MonitorStrip::followImage() {
  const auto& frame = model_.live.shown();
  if (!frame || model_.live.isFrozen()) return;
  const double ahead_s = frame->time_s - static_cast<double>(clock_.elapsed()) * 1e-3;
  // Imaging of another case counts its time from 0.
  constexpr double kOther_s = 1;
  if (!ahead_s_ || ahead_s > *ahead_s_ || *ahead_s_ - ahead_s > kOther_s) ahead_s_ = ahead_s;
}

void MonitorStrip::tick() {
  const Physiology& physiology = model_.imaging.tissue().body;
  const HeartRhythm rhythm = attempt_.view().line.rhythm;
  ecg_.advance(now_s(), rhythm, physiology.heartRate_perMin);
  trace_->setTime(now_s());
  beep(now_s());
  const auto rate = ecg_.rate_perMin(now_s());
  rate_->setText(rate ? tr("HR %1").arg(*rate, 0, 'f', 0) : tr("HR --"));
  pressure_->setText(tr("%1/%2").arg(physiology.systolic_mmHg, 0, 'f', 0).arg(physiology.diastolic_mmHg, 0, 'f', 0));
  rhythm_->setText(rhythm == HeartRhythm::Tachycardia  ? tr("Tachycardia")
                   : rhythm == HeartRhythm::ExtraBeats ? tr("Extra beats")
                                                       : QString());
  rhythm_->setVisible(rhythm != HeartRhythm::Sinus);
}

/// Beats since the last call; none after a pause, in which the monitor was hidden.
void MonitorStrip::beep(double now_s) {
  static const std::vector<float> kNormal = toneOf(880), kWide = toneOf(660);
  constexpr double kPause_s = 0.5;
  const double from_s = std::exchange(beeped_s_, now_s);
  ui::Sound& sound = workspace_.sound();
  if (!sound.isOn() || now_s - from_s > kPause_s) return;
  for (const Electrocardiogram::Beat& beat : ecg_.beats())
    if (beat.time_s > from_s && beat.time_s <= now_s) sound.play(beat.isWide ? kWide : kNormal);
}

void MonitorStrip::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  QMetaObject::invokeMethod(
      this, [this] { refresh(); }, Qt::QueuedConnection);
}

void MonitorStrip::refresh() {
  const bool isShown = attempt_.isRunning() && hasLine(attempt_.procedure());
  setVisible(isShown);
  isShown ? timer_.start() : timer_.stop();
}

}  // namespace insonate::train
