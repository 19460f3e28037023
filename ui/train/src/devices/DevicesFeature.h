#pragma once

#include "../feature/Feature.h"

#include <insonate/ui/HandsChoice.h>

#include <QPointer>

class QAction;

namespace insonate::train {

class CameraControl;
class DevicePanel;
class ForceCues;
class GamepadControl;

/// The feature for the devices that move probe and needle, and for the panel of haptic devices.
class DevicesFeature final : public Feature {
  Q_OBJECT

 public:
  DevicesFeature(TrainModel& model, TrainLayout& layout);
  ~DevicesFeature() override;

  /// Action that shows the panel.
  QAction& panelAction() { return *panelAction_; }
  /// Assigns devices to probe and needle, and opens the windows in which the user sets them up.
  void setHands(ui::HandsChoice choice);
  void save(QSettings& settings) const override;
  void restore(QSettings& settings) override;

 private:
  void showPanel();

  QAction* panelAction_ = nullptr;
  CameraControl* camera_ = nullptr;
  GamepadControl* gamepad_ = nullptr;
  ForceCues* cues_ = nullptr;
  QPointer<DevicePanel> panel_;  ///< the panel; null until it is first shown
};

}  // namespace insonate::train
