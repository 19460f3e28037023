#include "DevicePanel.h"

#include "CameraDialog.h"
#include "DeviceList.h"
#include "ForceCues.h"
#include "GamepadDialog.h"
#include "HandPlots.h"
#include "HandSection.h"

#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QCheckBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QScreen>
#include <QVBoxLayout>
#include <algorithm>

namespace insonate::train {
namespace {

constexpr int kTick_ms = 100, kCount_ms = 500, kFrame_px = 40;

}  // namespace

DevicePanel::DevicePanel(HapticControl& hands, const OtherHands& others, QWidget* parent)
    : QDialog(parent), hands_(hands), camera_(others.camera) {
  setObjectName("devicePanel");
  setWindowTitle(tr("Devices"));
  setModal(false);
  // With its frame, as high as the screen at most.
  resize(860, std::min(840, QGuiApplication::primaryScreen()->availableGeometry().height() - kFrame_px));
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(ui::kLargeGap, ui::kLargeGap, ui::kLargeGap, ui::kLargeGap);
  box->setSpacing(ui::kGap);
  list_ = new DeviceList(hands_, this);
  box->addWidget(list_, 1);
  buildButtons(others);
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

/// Adds the buttons for hands without a device of their own on USB.
void DevicePanel::buildButtons(const OtherHands& others) {
  auto* useCamera = ui::pushButton("useCamera", tr("Use camera ..."),
                                   tr("Follows printed bodies with a webcam, as probe and needle"), Qt::TabFocus);
  auto* controller = ui::pushButton("setController", tr("Game controller ..."),
                                    tr("Shows and changes the functions of sticks and buttons"), Qt::TabFocus);
  auto* cues = new QCheckBox(tr("Show and sound forces"));
  cues->setObjectName("showForces");
  cues->setToolTip(
      tr("Shows contact and resistance at the lower edge of the image, and marks punctures, with a click if the sound "
         "is on"));
  cues->setFocusPolicy(Qt::TabFocus);
  cues->setChecked(others.cues.isOn());
  connect(cues, &QCheckBox::toggled, &others.cues, &ForceCues::setOn);
  list_->addButtons({useCamera, controller, cues});
  connect(useCamera, &QPushButton::clicked, this, [this] { showCamera(); });
  connect(controller, &QPushButton::clicked, this, [this, &gamepad = others.gamepad] {
    if (!gamepadDialog_) gamepadDialog_ = new GamepadDialog(gamepad, this);
    gamepadDialog_->show();
    gamepadDialog_->raise();
  });
}

void DevicePanel::showCamera() {
  if (!cameraDialog_) cameraDialog_ = new CameraDialog(camera_, this);
  cameraDialog_->show();
  cameraDialog_->raise();
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
  auto devices = hands_.session().devices().devices();
  for (const HapticTool hand : {kProbeTool, kNeedleTool})
    if (hands_.session().isMouseAssigned(hand)) devices.push_back(hands_.session().assignedDevice(hand));
  for (const auto& device : devices) {
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
