#include "DeviceChoice.h"

#include <insonate/haptics/Gamepad.h>

#include <QSettings>

namespace insonate::train {

void DeviceChoice::setDevice(HapticTool hand, const QString& device) {
  const HapticTool other = hand == kProbeTool ? kNeedleTool : kProbeTool;
  if (!device.isEmpty() && devices_[other] == device) devices_[other].clear();
  devices_[hand] = device;
}

bool DeviceChoice::isMouseAssigned(HapticTool hand) const {
  return devices_[hand].isEmpty() || devices_[hand].startsWith(QLatin1String(kGamepadIds));
}

bool DeviceChoice::has(const QString& device) const {
  return device == devices_[kProbeTool] || device == devices_[kNeedleTool] || device == pedal_;
}

bool DeviceChoice::isAny() const {
  return !devices_[kProbeTool].isEmpty() || !devices_[kNeedleTool].isEmpty() || !pedal_.isEmpty();
}

void DeviceChoice::save(QSettings& settings) const {
  settings.setValue("probeHand", devices_[kProbeTool]);
  settings.setValue("needleHand", devices_[kNeedleTool]);
  settings.setValue("pedal", pedal_);
  settings.beginWriteArray("devices");
  int n = 0;
  for (auto it = mappings_.begin(); it != mappings_.end(); ++it) {
    settings.setArrayIndex(n++);
    settings.setValue("id", it.key());
    train::save(it.value(), settings);
  }
  settings.endArray();
}

void DeviceChoice::restore(QSettings& settings) {
  const int count = settings.beginReadArray("devices");
  for (int n = 0; n < count; ++n) {
    settings.setArrayIndex(n);
    mappings_[settings.value("id").toString()] = restoredMapping(settings);
  }
  settings.endArray();
  devices_[kProbeTool] = settings.value("probeHand").toString();
  devices_[kNeedleTool] = settings.value("needleHand").toString();
  pedal_ = settings.value("pedal").toString();
}

}  // namespace insonate::train
