#include "MachineChooser.h"

#include "../model/ImagingModel.h"

#include <insonate/ultrasound/Machine.h>

namespace insonate::train {

MachineChooser::MachineChooser(ImagingModel& imaging, QWidget* parent) : QComboBox(parent), imaging_(imaging) {
  setObjectName("machine");
  setFocusPolicy(Qt::TabFocus);
  setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  setPlaceholderText(tr("own settings"));
  setToolTip(tr("Applies the image settings of a class of ultrasound machines"));
  for (const Machine& machine : machines()) {
    addItem(QString::fromStdString(machine.title), QString::fromStdString(machine.name));
    setItemData(count() - 1, QString::fromStdString(machine.about), Qt::ToolTipRole);
  }
  connect(this, qOverload<int>(&QComboBox::activated), this, [this] {
    const auto settings = settingsOf(currentData().toString().toStdString(), imaging_.probe(), imaging_.settings());
    if (settings) imaging_.setSettings(*settings);
  });
  connect(&imaging_, &ImagingModel::setupChanged, this, &MachineChooser::showCurrent);
  showCurrent();
}

void MachineChooser::showCurrent() {
  const Machine* machine = machineOf(imaging_.settings(), imaging_.probe());
  setCurrentIndex(machine ? findData(QString::fromStdString(machine->name)) : -1);
}

}  // namespace insonate::train
