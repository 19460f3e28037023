#include "LayoutFeature.h"

#include "Columns.h"
#include "TrainLayout.h"

#include <QAction>
#include <QSettings>

namespace insonate::train {

LayoutFeature::LayoutFeature(TrainModel& model, TrainLayout& layout)
    : Feature(model, layout),
      leftHanded_(layout.addAction(tr("Left-handed layout"), tr("Controls on the right, patient on the left"))) {
  connect(leftHanded_, &QAction::toggled, this, [this](bool on) { layout_.columns().setLeftHanded(on); });
}

void LayoutFeature::save(QSettings& settings) const {
  settings.setValue("leftHanded", leftHanded_->isChecked());
  layout_.columns().save(settings);
}

void LayoutFeature::restore(QSettings& settings) {
  // First the order, then the widths.
  leftHanded_->setChecked(settings.value("leftHanded", false).toBool());
  layout_.columns().restore(settings);
}

}  // namespace insonate::train
