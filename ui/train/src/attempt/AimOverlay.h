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

/// Returns the aim of a needle in an image plane. A needle counts as aimed in-plane, and has a line, if its angle to
/// the plane is below 30 degrees and its tip lies in the slice. Any other needle has the point at which it will cross
/// the plane, if there is one.
views::NeedlePathOverlay aimOf(const Needle& needle, const Transform& patientFromProbe, const ImagingSetup& setup);

/// Draws the needle's aim over the image during a guided attempt, while the aim is switched on.
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
