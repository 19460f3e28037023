#include "DevicePanel.h"

#include "DeviceList.h"
#include "HandPlots.h"
#include "HandSection.h"

#include <insonate/ui/Theme.h>

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace insonate::train {
namespace {

constexpr int kTick_ms = 100, kCount_ms = 500;

}  // namespace

DevicePanel::DevicePanel(HapticControl& hands, QWidget* parent) : QDialog(parent), hands_(hands) {
  setObjectName("devicePanel");
  setWindowTitle(tr("Devices"));
  setModal(false);
  resize(820, 720);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(ui::kLargeGap, ui::kLargeGap, ui::kLargeGap, ui::kLargeGap);
  box->setSpacing(ui::kGap);
  list_ = new DeviceList(hands_, this);
  box->addWidget(list_, 1);
  auto* both = new QHBoxLayout;
  both->setSpacing(ui::kGap);
  for (const HapticTool hand : {kProbeTool, kNeedleTool}) {
    sections_[hand] = new HandSection(hands_, hand, this);
    connect(sections_[hand], &HandSection::refused, this, &DevicePanel::refused);
    both->addWidget(sections_[hand], 1);
  }
  box->addLayout(both);
  plots_ = new HandPlots(this);
  box->addWidget(plots_);
  pace_ = new QLabel(this);
  pace_->setObjectName("pace");
  pace_->setToolTip(
      tr("Time that the servo needs in each cycle to compute the forces of both hands, in µs, measured since the servo "
         "started; the limit is 1000 µs"));
  rights_ = new QLabel(this);
  rights_->setObjectName("rights");
  for (QLabel* label : {pace_, rights_}) {
    ui::setRole(label, "quiet");
    label->setWordWrap(true);
    box->addWidget(label);
  }
  timer_.setInterval(kTick_ms);
  connect(&timer_, &QTimer::timeout, this, [this] { look(); });
}

void DevicePanel::showEvent(QShowEvent* event) {
  sinceCount_.start();
  timer_.start();
  look();
  QDialog::showEvent(event);
}

void DevicePanel::hideEvent(QHideEvent* event) {
  timer_.stop();
  QDialog::hideEvent(event);
}

/// Computes the rate of device states over the last half second.
void DevicePanel::count() {
  const double gone_s = double(sinceCount_.restart()) / 1000;
  for (const auto& device : hands_.session().devices().devices()) {
    const QString id = QString::fromStdString(device->info().id);
    const quint64 reports = device->counters().reports;
    if (counted_.contains(id) && gone_s > 0) rates_Hz_[id] = double(reports - counted_[id]) / gone_s;
    counted_[id] = reports;
  }
}

void DevicePanel::look() {
  hands_.checkDevices();
  if (sinceCount_.elapsed() >= kCount_ms) count();
  const int known = int(hands_.session().devices().devices().size());
  const bool more = std::exchange(known_, known) != known;
  list_->refresh(rates_Hz_);
  const ServoSnapshot now = hands_.session().snapshot();
  std::array<double, 2> force_N{-1, -1}, rate_Hz{-1, -1};
  for (const HapticTool hand : {kProbeTool, kNeedleTool}) {
    if (more) sections_[hand]->refresh();
    const double rate = rates_Hz_.value(hands_.choice().device(hand));
    sections_[hand]->show(now, rate);
    if (!now.present[hand] || hands_.choice().device(hand).isEmpty()) continue;
    force_N[hand] = norm(now.output.tools[hand].force.force_N);
    rate_Hz[hand] = rate;
  }
  plots_->add(force_N, rate_Hz);
  const TickTiming timing = hands_.session().tickTiming();
  rights_->setText(QString::fromStdString(hands_.session().realTimeRights().sentence));
  pace_->setText(timing.ticks == 0
                     ? tr("The servo is off: nothing is assigned to either hand.")
                     : tr("Servo cycle: median %1 µs, 99.9 % of cycles within %2 µs; %3 of %4 cycles late.")
                           .arg(timing.p50_us, 0, 'f', 0)
                           .arg(timing.p999_us, 0, 'f', 0)
                           .arg(timing.late)
                           .arg(timing.ticks));
}

}  // namespace insonate::train
