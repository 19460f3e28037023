#pragma once

#include <insonate/core/Transform.h>
#include <insonate/views/UltrasoundView.h>

#include <QObject>

namespace insonate {
struct ImagingSetup;
struct Needle;
}  // namespace insonate

namespace insonate::train {

class AttemptControl;
class DisclosureModel;
class LiveModel;

/// Returns the aim of a needle in an image plane. A needle that is nearer than 30 degrees to the plane, with its tip in
/// the slice, is aimed in-plane and has a line; otherwise it has the point in which it will cross the plane, if any.
views::PictureAim aimOf(const Needle& needle, const Transform& patientFromProbe, const ImagingSetup& setup);

/// The needle's aim over the image during a guided attempt, while it is switched on.
class AimOverlay final : public QObject {
  Q_OBJECT

 public:
  AimOverlay(DisclosureModel& disclosure, LiveModel& live, AttemptControl& attempt, views::UltrasoundView& image,
             QObject* parent);

  bool isOn() const { return isOn_; }
  void setOn(bool isOn);

 Q_SIGNALS:
  void switched(bool isOn);

 private:
  void show();

  DisclosureModel& disclosure_;
  LiveModel& live_;
  AttemptControl& attempt_;
  views::UltrasoundView& image_;
  bool isOn_ = true;
};

}  // namespace insonate::train
