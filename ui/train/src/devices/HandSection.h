#pragma once

#include "../model/HandsControl.h"

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

/// Controls of one hand in the device panel: its device, the mapping to the tool, force limits, and position.
class HandSection final : public QFrame {
  Q_OBJECT

 public:
  HandSection(HandsControl& hands, Hand hand, QWidget* parent = nullptr);

  /// Updates the list of devices and the controls.
  void refresh();
  /// Shows position and force of the hand; call it a few times per second. `rate_Hz`: state reports per second of the
  /// hand's device.
  void show(const ServoSnapshot& now, double rate_Hz);

 Q_SIGNALS:
  void refused(const QString& sentence);

 private:
  QWidget* labelled(const QString& name, QWidget* widget);
  QWidget* buildOffsets();
  QWidget* buildButtons();
  void change(const std::function<void(HandMapping&)>& edit);

  HandsControl& hands_;
  const Hand hand_;
  QComboBox *device_ = nullptr, *stand_ = nullptr;
  QLabel *state_ = nullptr, *pose_ = nullptr, *force_ = nullptr;
  QWidget* mapping_ = nullptr;
  std::array<NumberField*, 3> apart_{};
  ui::ValueSlider *gain_ = nullptr, *most_ = nullptr;
  QPushButton *begin_ = nullptr, *calibrate_ = nullptr, *test_ = nullptr;
  bool refreshing_ = false;
};

/// Describes a device's phase in a few words.
QString wordsOf(DevicePhase phase);

}  // namespace insonate::train
