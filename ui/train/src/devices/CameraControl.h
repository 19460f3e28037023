#pragma once

#include <insonate/simulator/CameraHands.h>

#include <QHash>
#include <QObject>
#include <QString>
#include <QTimer>
#include <QVector>
#include <array>
#include <memory>

class QSettings;

namespace insonate::train {

class HapticControl;

/// The camera that follows printed bodies as probe and needle. Remembers the camera, and the calibration of each
/// camera. The camera is off until the user chooses one, or until a saved choice needs it.
class CameraControl final : public QObject {
  Q_OBJECT

 public:
  struct Choice {
    QString source;  ///< argument of use()
    QString name;    ///< name for the user
  };

  explicit CameraControl(HapticControl& hands, QObject* parent = nullptr);
  ~CameraControl() override;

  /// Lists the cameras that are plugged in.
  static QVector<Choice> cameras();
  static QString sourceOfFile(const QString& path);

  /// Switches the camera on; an empty source switches it off.
  void use(const QString& source);
  const QString& source() const { return source_; }
  /// The hands that the camera follows; null while the camera is off.
  CameraHands* hands() const { return camera_.get(); }

  void save(QSettings& settings) const;
  void restore(QSettings& settings);

 Q_SIGNALS:
  void changed();  ///< emitted when the camera was switched on or off
  void messageReported(const QString& sentence);

 private:
  void open();
  void look();

  HapticControl& hands_;
  QString source_;
  QHash<QString, CameraCalibration> calibrations_;  ///< by source
  std::array<std::shared_ptr<PoseDevice>, 2> devices_;
  bool areAdded_ = false;  ///< true: the hub lists the devices
  std::unique_ptr<CameraHands> camera_;
  QString outcome_;  ///< last outcome of a calibration that was taken over
  QTimer timer_;
};

}  // namespace insonate::train
