#pragma once

#include <QDialog>
#include <QTimer>
#include <array>

class QComboBox;
class QLabel;
class QPushButton;

namespace insonate::train {

class CameraControl;
class CameraSight;

/// Window in which the user chooses the camera that follows the printed bodies, sees the bodies with advice, and
/// calibrates the camera.
class CameraDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit CameraDialog(CameraControl& camera, QWidget* parent = nullptr);

  /// Writes the sheet with the bodies, the board and the outline as PDF; reports the outcome.
  void print(const QString& file);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* buildChoice();
  QWidget* buildButtons();
  void fillChoice();
  void choose();
  void look();

  CameraControl& camera_;
  QComboBox* source_ = nullptr;
  CameraSight* sight_ = nullptr;
  std::array<QLabel*, 2> advice_{};
  QLabel *state_ = nullptr, *task_ = nullptr;
  QPushButton *lens_ = nullptr, *desk_ = nullptr;
  QString printed_;  ///< sentence about the sheet that was written last
  QTimer timer_;
};

}  // namespace insonate::train
