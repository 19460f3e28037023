#include "LayoutFeature.h"

#include "Columns.h"
#include "TrainLayout.h"

#include <QAction>
#include <QSettings>

namespace insonate::train {

LayoutFeature::LayoutFeature(TrainModel& model, TrainLayout& layout) : Feature(model, layout) {
  addCommand({.id = "train.layout.leftHanded",
              .text = tr("Left-handed layout"),
              .does = tr("puts the controls on the right and the patient on the left"),
              .listed = {},
              .keys = {},
              .perform = [this](ui::KeyPress) { setLeftHanded(!isLeftHanded_); },
              .isAvailable = [] { return true; }});
  leftHandedAction_ = addSwitch("train.layout.leftHanded", [this] { return isLeftHanded_; });
}

void LayoutFeature::setLeftHanded(bool isLeftHanded) {
  isLeftHanded_ = isLeftHanded;
  leftHandedAction_->setChecked(isLeftHanded);
  layout_.columns().setLeftHanded(isLeftHanded);
}

void LayoutFeature::save(QSettings& settings) const {
  settings.setValue("leftHanded", isLeftHanded_);
  layout_.columns().save(settings);
}

void LayoutFeature::restore(QSettings& settings) {
  // First the order, then the widths.
  setLeftHanded(settings.value("leftHanded", false).toBool());
  layout_.columns().restore(settings);
}

}  // namespace insonate::train
