#include "HandSection.h"

#include "../layout/NumberField.h"

#include <insonate/ui/Theme.h>
#include <insonate/ui/ValueSlider.h>
#include <insonate/ui/Widgets.h>

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace insonate::train {
namespace {

constexpr double kTest_N = 0.8;

const char* const kStands[] = {"the patient's head", "the patient's right", "the patient's left", "the patient's feet"};

QPushButton* handButton(const char* object, const QString& text, const QString& says) {
  return ui::pushButton(object, text, says, Qt::TabFocus);
}

QComboBox* combo(const char* object, const QString& says) {
  return ui::choiceBox(object, {}, says, Qt::TabFocus);
}

}  // namespace

QString displayText(DevicePhase phase) {
  switch (phase) {
    case DevicePhase::kAbsent:
      return HandSection::tr("not connected");
    case DevicePhase::kOpening:
      return HandSection::tr("connecting");
    case DevicePhase::kReady:
      return HandSection::tr("ready");
    case DevicePhase::kStreaming:
      return HandSection::tr("in use");
    case DevicePhase::kLost:
      return HandSection::tr("connection lost");
    case DevicePhase::kFailed:
      return HandSection::tr("unusable");
  }
  return {};
}

HandSection::HandSection(HapticControl& hands, HapticTool hand, QWidget* parent)
    : QFrame(parent), hands_(hands), hand_(hand) {
  const bool probe = hand == kProbeTool;
  setObjectName(probe ? "probeHand" : "needleHand");
  ui::setRole(this, "panel");
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(12, 8, 12, 8);
  box->setSpacing(4);
  auto* heading = new QLabel(probe ? tr("Hand with the probe") : tr("Hand with the needle"));
  ui::setRole(heading, "heading");
  box->addWidget(heading);
  device_ = combo("device", tr("Device in this hand, or mouse and keyboard"));
  box->addWidget(labeled(tr("device"), device_));
  state_ = new QLabel;
  state_->setObjectName("state");
  state_->setWordWrap(true);
  box->addWidget(state_);
  mapping_ = new QWidget;
  auto* inner = new QVBoxLayout(mapping_);
  inner->setContentsMargins(0, 0, 0, 0);
  inner->setSpacing(4);
  stand_ = combo("stand", tr("Your seat relative to the patient, who lies supine"));
  for (const char* one : kStands) stand_->addItem(tr(one));
  inner->addWidget(labeled(tr("seen from"), stand_));
  inner->addWidget(labeled(tr("offset"), buildOffsets()));
  gain_ = new ui::ValueSlider(tr("forces"), tr("%"), {0, 100, 100, 5, 0},
                              tr("Share of the computed force that is sent to the hand"));
  gain_->setObjectName("gain");
  most_ = new ui::ValueSlider(tr("maximum"), tr("N"), {0, 12, HandMapping{}.userMaxForce_N, 0.5, 1},
                              tr("Maximum force sent to the hand; the limit of the device also applies"));
  most_->setObjectName("mostForce");
  inner->addWidget(gain_);
  inner->addWidget(most_);
  inner->addWidget(buildButtons());
  box->addWidget(mapping_);
  pose_ = new QLabel;
  pose_->setObjectName("pose");
  pose_->setToolTip(tr("Position of the stylus in the device frame, in mm: to the right, up, toward you"));
  force_ = new QLabel;
  force_->setObjectName("force");
  force_->setToolTip(tr("Force that is sent to the hand, in N"));
  box->addWidget(pose_);
  box->addWidget(force_);
  box->addStretch();
  connect(device_, qOverload<int>(&QComboBox::activated), this,
          [this] { hands_.assign(hand_, device_->currentData().toString()); });
  connect(stand_, qOverload<int>(&QComboBox::activated), this,
          [this](int stand) { change([&](HandMapping& to) { to.stand = Stand(stand); }); });
  connect(gain_, &ui::ValueSlider::valueChanged, this,
          [this](double percent) { change([&](HandMapping& to) { to.gain = percent / 100; }); });
  connect(most_, &ui::ValueSlider::valueChanged, this,
          [this](double newtons) { change([&](HandMapping& to) { to.userMaxForce_N = newtons; }); });
  connect(&hands_, &HapticControl::handsChanged, this, [this] { refresh(); });
  refresh();
}

QWidget* HandSection::labeled(const QString& name, QWidget* widget) {
  auto* row = new QWidget;
  auto* box = new QHBoxLayout(row);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kGap);
  auto* label = new QLabel(name);
  ui::setRole(label, "quiet");
  label->setMinimumWidth(fontMetrics().horizontalAdvance(tr("seen from")) + 4);
  widget->setAccessibleName(name);
  box->addWidget(label);
  box->addWidget(widget, 1);
  return row;
}

QWidget* HandSection::buildOffsets() {
  const QString says[] = {tr("to your right"), tr("up"), tr("toward you")};
  const QString names[] = {tr("right"), tr("up"), tr("near")};
  auto* all = new QWidget;
  auto* box = new QHBoxLayout(all);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(4);
  for (int axis = 0; axis < 3; ++axis) {
    auto* field = new NumberField(names[axis], tr(" mm"), {-300, 300, 5, 0}, all);
    field->setObjectName(QStringLiteral("apart") + QString::number(axis));
    field->setAccessibleName(tr("Offset of the tool from its device, %1, in mm").arg(says[axis]));
    field->setToolTip(
        tr("Offset of the tool from its device, %1, in mm. With offsets, two devices can stand apart on a "
           "desk while their tools meet")
            .arg(says[axis]));
    field->setTyped([this, axis](double value) { change([&](HandMapping& to) { to.apart_mm[axis] = value; }); });
    field->setRefused([this](const QString& sentence) { Q_EMIT refused(sentence); });
    apart_[axis] = field;
    box->addWidget(field, 1);
  }
  return all;
}

QWidget* HandSection::buildButtons() {
  auto* row = new QWidget;
  auto* box = new QHBoxLayout(row);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(4);
  begin_ = handButton("beginHere", tr("Begin here"),
                      tr("Assigns the present pose of the stylus to the start pose of the tool: the probe stays in "
                         "place, the needle is placed beside the probe"));
  calibrate_ =
      handButton("calibrate", tr("Home"), tr("Makes the present posture of the device the zero of its encoders"));
  test_ = handButton("testForce", tr("Test force"),
                     tr("Pushes the stylus up with 0.8 N for a second. Hold the stylus loosely"));
  for (QPushButton* one : {begin_, calibrate_, test_}) box->addWidget(one, 1);
  connect(begin_, &QPushButton::clicked, this, [this] { hands_.beginHere(hand_); });
  connect(calibrate_, &QPushButton::clicked, this, [this] {
    if (const auto device = hands_.deviceOf(hands_.choice().device(hand_))) device->calibrate();
  });
  connect(test_, &QPushButton::clicked, this, [this] { hands_.session().testForce(hand_, {0, kTest_N, 0}); });
  return row;
}

void HandSection::change(const std::function<void(HandMapping&)>& edit) {
  const QString device = hands_.choice().device(hand_);
  if (refreshing_ || device.isEmpty()) return;
  HandMapping mapping = hands_.choice().mapping(device);
  edit(mapping);
  hands_.setMapping(device, mapping);
}

void HandSection::refresh() {
  refreshing_ = true;
  const QString assigned = hands_.choice().device(hand_);
  {
    const QSignalBlocker quiet(device_);
    device_->clear();
    device_->addItem(tr("mouse and keyboard"), QString());
    for (const auto& device : hands_.session().devices().devices())
      if (device->info().kind != DeviceKind::kPedal)
        device_->addItem(QString::fromStdString(device->info().name), QString::fromStdString(device->info().id));
    if (device_->findData(assigned) < 0) device_->addItem(tr("%1 (not connected)").arg(assigned), assigned);
    device_->setCurrentIndex(device_->findData(assigned));
  }
  const auto device = hands_.deviceOf(assigned);
  const bool pushes = device && device->info().limits.forceAxes > 0;
  mapping_->setVisible(!hands_.choice().isMouseAssigned(hand_));
  for (QWidget* one : {static_cast<QWidget*>(gain_), static_cast<QWidget*>(most_), static_cast<QWidget*>(test_)})
    one->setEnabled(pushes);
  const HandMapping mapping = hands_.choice().mapping(assigned);
  stand_->setCurrentIndex(int(mapping.stand));
  for (int axis = 0; axis < 3; ++axis) apart_[axis]->show(mapping.apart_mm[axis]);
  gain_->setValue(mapping.gain * 100);
  most_->setValue(mapping.userMaxForce_N);
  refreshing_ = false;
}

void HandSection::show(const ServoSnapshot& now, double rate_Hz) {
  const auto device = hands_.session().assignedDevice(hand_);
  if (const auto known = hands_.deviceOf(hands_.choice().device(hand_)); known && !known->error().empty())
    state_->setText(QString::fromStdString(known->error()));
  else if (device)
    // Mouse and keys send none.
    state_->setText(rate_Hz > 0
                        ? tr("%1, %2 updates per second").arg(displayText(device->phase())).arg(rate_Hz, 0, 'f', 0)
                        : displayText(device->phase()));
  else if (!hands_.choice().device(hand_).isEmpty())
    state_->setText(known ? displayText(known->phase()) : tr("waiting until the device is connected"));
  else
    state_->setText(hand_ == kProbeTool ? tr("the probe follows the mouse") : tr("no needle is in use"));
  const bool there = device && now.present[hand_];
  pose_->setVisible(there);
  force_->setVisible(there);
  if (!there) return;
  const Vec3 p = now.states[hand_].deviceFromStylus.offset;
  pose_->setText(tr("%1   %2   %3 mm").arg(p.x, 7, 'f', 1).arg(p.y, 7, 'f', 1).arg(p.z, 7, 'f', 1));
  const ToolOutput& out = now.output.tools[hand_];
  const bool pushes = device->info().limits.forceAxes > 0;
  force_->setText(
      pushes ? (out.limited ? tr("%1 N, reduced to the limit") : tr("%1 N")).arg(norm(out.force.force_N), 0, 'f', 2)
             : tr("%1 N, above this device's limit").arg(norm(out.wanted_N), 0, 'f', 2));
}

}  // namespace insonate::train
