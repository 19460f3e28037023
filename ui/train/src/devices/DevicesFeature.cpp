#include "DevicesFeature.h"

#include "../layout/TrainLayout.h"
#include "../model/TrainModel.h"
#include "DevicePanel.h"

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
}

DevicesFeature::~DevicesFeature() {
  delete panel_;
}

void DevicesFeature::showPanel() {
  if (!panel_) {
    panel_ = new DevicePanel(model_.hands, &layout_.workspace());
    connect(panel_, &DevicePanel::refused, &model_.status, &StatusLine::showMessage);
  }
  panel_->show();
  panel_->raise();
  panel_->activateWindow();
}

void DevicesFeature::save(QSettings& settings) const {
  settings.beginGroup(kHandsGroup);
  model_.hands.save(settings);
  settings.endGroup();
}

void DevicesFeature::restore(QSettings& settings) {
  settings.beginGroup(kHandsGroup);
  model_.hands.restore(settings);
  settings.endGroup();
}

}  // namespace insonate::train
