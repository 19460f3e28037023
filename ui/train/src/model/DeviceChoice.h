#pragma once

#include "HandMapping.h"

#include <QHash>
#include <QString>
#include <array>

class QSettings;

namespace insonate::train {

/// The devices that the user has chosen for probe, needle and pedal, by DeviceInfo::id, and the mapping of each device.
/// The choice is saved, also for devices that are not connected. An empty id means mouse and keys or, for the pedal, no
/// device.
class DeviceChoice {
 public:
  const QString& device(HapticTool hand) const { return devices_[hand]; }
  /// Assigns a device to probe or needle. If the device was assigned to the other tool, mouse and keys now move that
  /// tool.
  void setDevice(HapticTool hand, const QString& device);
  /// Tells whether mouse and keys move the tool, or a game controller, which moves it in the same way.
  bool isMouseAssigned(HapticTool hand) const;
  const QString& pedal() const { return pedal_; }
  void setPedal(const QString& device) { pedal_ = device; }

  HandMapping mapping(const QString& device) const { return mappings_.value(device); }
  bool hasMapping(const QString& device) const { return mappings_.contains(device); }
  void setMapping(const QString& device, const HandMapping& mapping) { mappings_[device] = mapping; }

  /// Tells whether this device is assigned to probe or needle, or as the pedal.
  bool has(const QString& device) const;
  bool isAny() const;

  void save(QSettings& settings) const;
  void restore(QSettings& settings);

 private:
  std::array<QString, 2> devices_;
  QString pedal_;
  QHash<QString, HandMapping> mappings_;
};

}  // namespace insonate::train
