#pragma once

#include <insonate/cases/PatientCase.h>

#include <QObject>

namespace insonate::prepare {

class LivePatient;
class Notice;
class OpenCase;

/// The point of the patient at which all slices intersect. The probe follows this point.
class Crosshair : public QObject {
  Q_OBJECT

 public:
  Crosshair(OpenCase& openCase, LivePatient& live, Notice& notice, QObject* parent);

  Vec3 position_mm() const { return position_mm_; }
  /// Sets the position, clamped to the volume.
  void moveTo(Vec3 patient_mm);
  /// Moves crosshair and probe to the case's start pose.
  void goToStart();
  /// Moves crosshair and probe to a pose.
  void goTo(const StartPose& pose);

 Q_SIGNALS:
  void moved();

 private:
  OpenCase& openCase_;
  LivePatient& live_;
  Notice& notice_;
  Vec3 position_mm_;
};

}  // namespace insonate::prepare
