#pragma once

#include "../feature/Feature.h"

#include <QPointer>

class QAction;

namespace insonate::train {

class DevicePanel;

/// The feature for the devices that move probe and needle, and for the panel of haptic devices.
class DevicesFeature final : public Feature {
  Q_OBJECT

 public:
  DevicesFeature(TrainModel& model, TrainLayout& layout);
  ~DevicesFeature() override;

  /// Action that shows the panel.
  QAction& panelAction() { return *panelAction_; }
  void save(QSettings& settings) const override;
  void restore(QSettings& settings) override;

 private:
  void showPanel();

  QAction* panelAction_ = nullptr;
  QPointer<DevicePanel> panel_;  ///< the panel; null until it is first shown
};

}  // namespace insonate::train
