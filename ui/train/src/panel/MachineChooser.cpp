#include "MachineChooser.h"

#include "../TrainSession.h"

#include <insonate/ui/QuietWheel.h>
#include <insonate/ultrasound/Machine.h>

namespace insonate::train {

MachineChooser::MachineChooser(TrainSession& session, QWidget* parent) : QComboBox(parent), session_(session) {
  setObjectName("machine");
  setFocusPolicy(Qt::TabFocus);
  new ui::QuietWheel(this);
  setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  setPlaceholderText(tr("own settings"));
  setToolTip(tr("Applies the image settings of a class of ultrasound machines"));
  for (const Machine& machine : machines()) {
    addItem(QString::fromStdString(machine.title), QString::fromStdString(machine.name));
    setItemData(count() - 1, QString::fromStdString(machine.about), Qt::ToolTipRole);
  }
  connect(this, qOverload<int>(&QComboBox::activated), this, [this] {
    const auto settings = settingsOf(currentData().toString().toStdString(), session_.probe(), session_.settings());
    if (settings) session_.setSettings(*settings);
  });
  connect(&session_, &TrainSession::setupChanged, this, &MachineChooser::showCurrent);
  showCurrent();
}

void MachineChooser::showCurrent() {
  const Machine* machine = machineOf(session_.settings(), session_.probe());
  setCurrentIndex(machine ? findData(QString::fromStdString(machine->name)) : -1);
}

}  // namespace insonate::train
