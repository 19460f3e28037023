#include "DevicesFeature.h"

#include "../layout/TrainLayout.h"
#include "../model/TrainModel.h"
#include "CameraControl.h"
#include "DevicePanel.h"
#include "ForceCues.h"
#include "GamepadControl.h"

#include <insonate/ui/Workspace.h>

#include <QAction>
#include <QSettings>

namespace insonate::train {
namespace {

constexpr const char* kHandsGroup = "hands";

}  // namespace

DevicesFeature::DevicesFeature(TrainModel& model, TrainLayout& layout) : Feature(model, layout) {
  addCommand({.id = "train.devices.show",
              .text = tr("Devices ..."),
              .does = tr("shows which haptic devices and pedals are connected, and what each device controls"),
              .listed = {},
              .keys = {},
              .perform = [this](ui::KeyPress) { showPanel(); },
              .isAvailable = [] { return true; }});
  panelAction_ = commands().action("train.devices.show");
  layout.addToViewMenu(*panelAction_);
  camera_ = new CameraControl(model.hands, this);
  connect(camera_, &CameraControl::messageReported, &model.status, &StatusLine::showMessage);
  gamepad_ = new GamepadControl(model, commands(), sdlGamepads, this);
  cues_ = new ForceCues(model, layout);
}

DevicesFeature::~DevicesFeature() {
  delete panel_;
}

void DevicesFeature::showPanel() {
  if (!panel_) {
    gamepad_->start();
    panel_ = new DevicePanel(model_.hands, {*camera_, *gamepad_, *cues_}, &layout_.workspace());
    connect(panel_, &DevicePanel::refused, &model_.status, &StatusLine::showMessage);
  }
  panel_->show();
  panel_->raise();
  panel_->activateWindow();
}

void DevicesFeature::setHands(ui::HandsChoice choice) {
  HapticControl& hands = model_.hands;
  const auto assign = [&](const char* probe, const char* needle) {
    hands.assign(kProbeTool, QLatin1String(probe));
    hands.assign(kNeedleTool, QLatin1String(needle));
  };
  switch (choice) {
    case ui::HandsChoice::Mouse:
      return assign("", "");
    case ui::HandsChoice::Camera:
      assign("camera:probe", "camera:needle");
      showPanel();
      return panel_->showCamera();
    case ui::HandsChoice::Controller:
      assign("gamepad:left", "gamepad:right");
      return showPanel();
    case ui::HandsChoice::Haptic:
      showPanel();
      // One device holds the needle, whose forces teach most; a second one the probe.
      for (const auto& device : hands.session().devices().devices())
        if (device->info().kind == DeviceKind::kForce)
          hands.assign(hands.choice().device(kNeedleTool).isEmpty() ? kNeedleTool : kProbeTool,
                       QString::fromStdString(device->info().id));
  }
}

void DevicesFeature::save(QSettings& settings) const {
  settings.beginGroup(kHandsGroup);
  model_.hands.save(settings);
  camera_->save(settings);
  gamepad_->save(settings);
  cues_->save(settings);
  settings.endGroup();
}

void DevicesFeature::restore(QSettings& settings) {
  settings.beginGroup(kHandsGroup);
  model_.hands.restore(settings);
  camera_->restore(settings);
  gamepad_->restore(settings);
  cues_->restore(settings);
  settings.endGroup();
}

}  // namespace insonate::train
