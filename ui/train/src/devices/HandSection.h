#pragma once

#include "../model/HapticControl.h"

#include <QFrame>
#include <array>

class QComboBox;
class QLabel;
class QPushButton;

namespace insonate::ui {
class ValueSlider;
}

namespace insonate::train {

class NumberField;

/// Controls of probe or needle in the device panel: the assigned device, the mapping from device to tool, force limits,
/// and position.
class HandSection final : public QFrame {
  Q_OBJECT

 public:
  HandSection(HapticControl& hands, HapticTool hand, QWidget* parent = nullptr);

  /// Updates the list of devices and the controls.
  void refresh();
  /// Shows position and force of the tool; call it a few times per second. `rate_Hz`: state reports per second from the
  /// tool's device.
  void show(const ServoSnapshot& now, double rate_Hz);

 Q_SIGNALS:
  void refused(const QString& sentence);

 private:
  QWidget* labeled(const QString& name, QWidget* widget);
  QWidget* buildOffsets();
  QWidget* buildButtons();
  void change(const std::function<void(HandMapping&)>& edit);

  HapticControl& hands_;
  const HapticTool hand_;
  QComboBox *device_ = nullptr, *stand_ = nullptr;
  QLabel *state_ = nullptr, *pose_ = nullptr, *force_ = nullptr;
  QWidget* mapping_ = nullptr;
  std::array<NumberField*, 3> apart_{};
  ui::ValueSlider *gain_ = nullptr, *most_ = nullptr;
  QPushButton *begin_ = nullptr, *calibrate_ = nullptr, *test_ = nullptr;
  bool refreshing_ = false;
};

/// Describes a device's phase in a few words.
QString displayText(DevicePhase phase);

}  // namespace insonate::train
