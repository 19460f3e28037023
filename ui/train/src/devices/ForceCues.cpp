#include "ForceCues.h"

#include "../layout/ImageColumn.h"
#include "../layout/TrainLayout.h"
#include "../model/TrainModel.h"

#include <insonate/ui/Sound.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Workspace.h>

#include <QPainter>
#include <QSettings>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace insonate::train {
namespace {

constexpr int kCueStep_ms = 50, kCaption_ms = 1500;
/// Forces that fill the bars.
constexpr double kFullProbe_N = 10, kFullNeedle_N = 3;

/// A soft click: a tone that decays within some milliseconds. Bone sounds lower than a puncture.
std::vector<float> clickOf(double frequency_Hz) {
  constexpr double kDuration_s = 0.03, kDecay_s = 0.006, kLoudness = 0.25;
  std::vector<float> samples(std::size_t(kDuration_s * ui::kSoundRate_Hz));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double t_s = double(i) / ui::kSoundRate_Hz;
    samples[i] = float(kLoudness * std::exp(-t_s / kDecay_s) * std::sin(2 * std::numbers::pi * frequency_Hz * t_s));
  }
  return samples;
}

}  // namespace

ForceCues::ForceCues(TrainModel& model, TrainLayout& layout) : model_(model), layout_(layout) {
  setObjectName("forceCues");
  setAccessibleName(tr("Forces on probe and needle"));
  setToolTip(tr("Pressure of the probe on the skin, and resistance of the tissue to the needle, in N"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  hide();
  timer_.setInterval(kCueStep_ms);
  connect(&timer_, &QTimer::timeout, this, [this] { look(); });
  connect(&model_.hands, &HapticControl::needleMet, this, [this](const NeedleEvent& event) {
    if (isOn_) click(event);
  });
  layout.image().add(ImageColumn::Note, this);
}

QSize ForceCues::sizeHint() const {
  return {200, fontMetrics().height() + 2 * ui::kSmallGap};
}

void ForceCues::setOn(bool isOn) {
  isOn_ = isOn;
  setVisible(isOn);
  caption_.clear();
  isOn ? timer_.start() : timer_.stop();
}

void ForceCues::click(const NeedleEvent& event) {
  constexpr double kPuncture_Hz = 1800, kBone_Hz = 500;
  const bool isBone = event.kind == NeedleEventKind::Struck;
  ui::Sound& sound = layout_.workspace().sound();
  if (sound.isOn()) sound.play(clickOf(isBone ? kBone_Hz : kPuncture_Hz));
  caption_ = isBone ? tr("hard resistance") : tr("puncture");
  sinceClick_.start();
  update();
}

void ForceCues::look() {
  const ServoSnapshot now = model_.hands.session().snapshot();
  const auto& frame = model_.live.shown();
  // Tenths, as the bars state them: at rest nothing is drawn again.
  const auto tenths = [](double force_N) { return std::round(10 * force_N) / 10; };
  const double probe_N = tenths(now.present[kProbeTool] ? now.output.skinForce_N : frame ? frame->press.force_N : 0);
  const double needle_N = tenths(now.present[kNeedleTool] ? std::abs(now.output.needle.axial_N) : 0);
  const bool isOver = !caption_.isEmpty() && sinceClick_.elapsed() > kCaption_ms;
  if (isOver) caption_.clear();
  const bool isOther = probe_N != probe_N_ || needle_N != needle_N_;
  probe_N_ = probe_N, needle_N_ = needle_N;
  if (isOther || isOver) update();
}

void ForceCues::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const int third = width() / 3, gap = ui::kGap;
  const auto bar = [&](int left, const QString& name, double force_N, double full_N, const QColor& color) {
    const QRect all(left + gap, ui::kSmallGap, third - 2 * gap, height() - 2 * ui::kSmallGap);
    painter.fillRect(all, ui::toQColor(views::theme::kRaised));
    QRect filled = all;
    filled.setWidth(int(all.width() * std::clamp(force_N / full_N, 0.0, 1.0)));
    painter.fillRect(filled, color);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(all, Qt::AlignCenter, tr("%1 %2 N").arg(name).arg(force_N, 0, 'f', 1));
  };
  bar(0, tr("probe"), probe_N_, kFullProbe_N, QColor(0x1f, 0x6f, 0x7d));
  bar(third, tr("needle"), needle_N_, kFullNeedle_N, QColor(0x9a, 0x62, 0x1a));
  painter.drawText(QRect(2 * third + gap, 0, third - 2 * gap, height()), Qt::AlignVCenter | Qt::AlignLeft, caption_);
}

void ForceCues::save(QSettings& settings) const {
  settings.setValue("forceCues", isOn_);
}

void ForceCues::restore(QSettings& settings) {
  setOn(settings.value("forceCues", false).toBool());
}

}  // namespace insonate::train
