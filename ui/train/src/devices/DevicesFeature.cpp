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

DevicesFeature::DevicesFeature(TrainModel& model, TrainLayout& layout)
    : Feature(model, layout),
      panelAction_(layout.addAction(
          tr("Devices ..."), tr("Haptic devices and pedals: which are connected, and what each one controls"), false)) {
  connect(panelAction_, &QAction::triggered, this, [this] { showPanel(); });
}

DevicesFeature::~DevicesFeature() {
  delete panel_;
}

void DevicesFeature::showPanel() {
  if (!panel_) {
    panel_ = new DevicePanel(model_.hands, &layout_.workspace());
    connect(panel_, &DevicePanel::refused, &model_.status, &StatusLine::say);
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
