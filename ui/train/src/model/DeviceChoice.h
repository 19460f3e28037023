#pragma once

#include "HandMapping.h"

#include <QHash>
#include <QString>
#include <array>

class QSettings;

namespace insonate::train {

/// The user's choice of devices for probe, needle and pedal, by DeviceInfo::id, and the mapping of each device.
/// Remembered, also while a device is not connected. An empty id stands for mouse and keys, or no pedal.
class DeviceChoice {
 public:
  const QString& device(Hand hand) const { return devices_[hand]; }
  /// A device is in one hand: the other returns to mouse and keys if it has this one.
  void setDevice(Hand hand, const QString& device);
  bool isMouse(Hand hand) const { return devices_[hand].isEmpty(); }
  const QString& pedal() const { return pedal_; }
  void setPedal(const QString& device) { pedal_ = device; }

  HandMapping mapping(const QString& device) const { return mappings_.value(device); }
  void setMapping(const QString& device, const HandMapping& mapping) { mappings_[device] = mapping; }

  /// Tells whether this device, or any at all, is chosen.
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
