#include "CameraControl.h"

#include "../model/HapticControl.h"

#include <insonate/camera/VideoDevice.h>
#include <insonate/ui/Text.h>

#include <QFileInfo>
#include <QSettings>
#include <QVariantList>
#include <cmath>
#include <utility>

namespace insonate::train {
namespace {

constexpr int kCameraLook_ms = 200;
const QString kCameraSource = QStringLiteral("camera:"), kFileSource = QStringLiteral("file:");

QVariantList listOf(const Transform& t) {
  QVariantList list;
  for (const Vec3& v : {t.linear.column[0], t.linear.column[1], t.linear.column[2], t.offset})
    list << v.x << v.y << v.z;
  return list;
}

std::optional<Transform> rigidFrom(const QVariantList& list) {
  if (list.size() != 12) return std::nullopt;
  const auto at = [&](int i) {
    return Vec3{list[3 * i].toDouble(), list[3 * i + 1].toDouble(), list[3 * i + 2].toDouble()};
  };
  const Transform rigid{{{at(0), at(1), at(2)}}, at(3)};
  constexpr double kOff = 1e-3;
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b <= a; ++b)
      if (!(std::abs(dot(rigid.linear.column[a], rigid.linear.column[b]) - double(a == b)) < kOff)) return std::nullopt;
  return determinant(rigid.linear) > 0 && isFinite(rigid.offset) ? std::optional(rigid) : std::nullopt;
}

/// Opens a source on the camera's thread.
Result<std::unique_ptr<CameraSource>> opened(const std::string& source) {
  if (source.starts_with("file:")) return openPlayedFrames(source.substr(5));
  const std::string name = source.substr(source.find(':') + 1);
  for (const VideoDeviceInfo& device : listVideoDevices())
    if (device.name == name) return openVideoDevice(device.path);
  return fail("The camera " + name + " is not connected, or may not be used. Plug it in, or check its permissions.");
}

}  // namespace

CameraControl::CameraControl(HapticControl& hands, QObject* parent)
    : QObject(parent), hands_(hands), devices_(CameraHands::makeDevices()) {
  timer_.setInterval(kCameraLook_ms);
  connect(&timer_, &QTimer::timeout, this, [this] { look(); });
}

CameraControl::~CameraControl() = default;

QVector<CameraControl::Choice> CameraControl::cameras() {
  QVector<Choice> all;
  for (const VideoDeviceInfo& device : listVideoDevices()) {
    const QString name = ui::qt(device.name);
    all.push_back({kCameraSource + name, name});
  }
  return all;
}

QString CameraControl::sourceOfFile(const QString& path) {
  return kFileSource + path;
}

void CameraControl::use(const QString& source) {
  if (source == source_) return;
  source_ = source;
  open();
}

void CameraControl::open() {
  camera_ = nullptr;  // before the next one: two objects must not post to one device
  outcome_.clear();
  if (source_.isEmpty()) {
    timer_.stop();
  } else {
    if (!std::exchange(areAdded_, true))
      for (const auto& device : devices_) hands_.session().devices().add(device);
    const CameraCalibration calibration = calibrations_.value(source_);
    hands_.setOnDesk(DeviceKind::kCamera, calibration.cameraFromDesk.has_value());
    camera_ = std::make_unique<CameraHands>([source = source_.toStdString()] { return opened(source); }, devices_,
                                            calibration);
    timer_.start();
  }
  hands_.checkDevices();
  Q_EMIT hands_.handsChanged();
  Q_EMIT changed();
}

/// Takes over the calibrations that the camera has finished.
void CameraControl::look() {
  const CameraState now = camera_->state();
  const QString outcome = ui::qt(now.outcome);
  if (std::exchange(outcome_, outcome) == outcome || outcome.isEmpty()) return;
  Q_EMIT messageReported(outcome);
  if (now.hasFailed) return;
  const CameraCalibration calibration = camera_->calibration();
  calibrations_[source_] = calibration;
  hands_.setOnDesk(DeviceKind::kCamera, calibration.cameraFromDesk.has_value());
}

void CameraControl::save(QSettings& settings) const {
  settings.setValue("camera", source_);
  settings.beginWriteArray("cameras");
  int n = 0;
  for (auto it = calibrations_.begin(); it != calibrations_.end(); ++it) {
    settings.setArrayIndex(n++);
    settings.setValue("source", it.key());
    if (it->lens) settings.setValue("lens", ui::qt(lensText(*it->lens)));
    if (it->cameraFromDesk) settings.setValue("desk", listOf(*it->cameraFromDesk));
  }
  settings.endArray();
}

void CameraControl::restore(QSettings& settings) {
  const int count = settings.beginReadArray("cameras");
  for (int n = 0; n < count; ++n) {
    settings.setArrayIndex(n);
    CameraCalibration& calibration = calibrations_[settings.value("source").toString()];
    if (auto lens = parseLens(settings.value("lens").toString().toStdString())) calibration.lens = *lens;
    calibration.cameraFromDesk = rigidFrom(settings.value("desk").toList());
  }
  settings.endArray();
  // The camera is switched on without the user only if it leads a hand.
  const QString source = settings.value("camera").toString();
  const bool isNeeded =
      hands_.choice().has(ui::qt(devices_[0]->info().id)) || hands_.choice().has(ui::qt(devices_[1]->info().id));
  if (isNeeded) use(source);
}

}  // namespace insonate::train
