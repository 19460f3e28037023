#pragma once

#include "../model/HapticControl.h"

#include <QDialog>
#include <QElapsedTimer>
#include <QHash>
#include <QPointer>
#include <QTimer>
#include <array>

class QLabel;

namespace insonate::train {

class CameraControl;
class CameraDialog;
class DeviceList;
class ForceCues;
class GamepadControl;
class GamepadDialog;
class HandPlots;
class HandSection;

/// Window for haptic devices: connections, assignment to probe and needle, forces, and timing of the servo. The panel
/// is a separate window, so that the user sees it together with the image. Uses no computing time while it is closed.
class DevicePanel final : public QDialog {
  Q_OBJECT

 public:
  /// Controls of the hands that have no haptic device.
  struct OtherHands {
    CameraControl& camera;
    GamepadControl& gamepad;
    ForceCues& cues;
  };
  DevicePanel(HapticControl& hands, const OtherHands& others, QWidget* parent = nullptr);

  DeviceList& list() { return *list_; }
  /// Opens the camera's window.
  void showCamera();

 Q_SIGNALS:
  void refused(const QString& sentence);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void look();
  void count();
  void buildButtons(const OtherHands& others);

  HapticControl& hands_;
  DeviceList* list_ = nullptr;
  std::array<HandSection*, 2> sections_{};
  HandPlots* plots_ = nullptr;
  QLabel *pace_ = nullptr, *rights_ = nullptr;
  CameraControl& camera_;
  QPointer<CameraDialog> cameraDialog_;    ///< null until it is first shown
  QPointer<GamepadDialog> gamepadDialog_;  ///< null until it is first shown
  QTimer timer_;
  QElapsedTimer sinceCount_;
  QHash<QString, quint64> counted_;  ///< number of state reports per device at the last count
  QHash<QString, double> rates_Hz_;
  int known_ = -1;  ///< number of devices when the lists of devices for probe and needle were filled; -1: not yet
};

}  // namespace insonate::train
