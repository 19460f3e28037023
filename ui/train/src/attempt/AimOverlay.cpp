#include "AimOverlay.h"

#include "../model/Disclosure.h"
#include "../model/LiveModel.h"
#include "AttemptControl.h"

#include <insonate/ultrasound/PointSpread.h>

#include <cmath>
#include <utility>

namespace insonate::train {

views::NeedlePathOverlay aimOf(const Needle& needle, const Transform& patientFromProbe, const ImagingSetup& setup) {
  constexpr double kInPlane = 0.5;  // sine of 30 degrees
  const Transform probeFromPatient = inverted(patientFromProbe);
  const Vec3 tip = probeFromPatient * needle.tip_mm;
  const Vec3 way = probeFromPatient.linear * needle.direction;
  views::NeedlePathOverlay aim;
  const double thickness_mm = sliceLaw(setup.probe, setup.settings.frequency_MHz).thickness_mm(std::max(0.0, tip.z));
  if (std::abs(tip.y) <= thickness_mm / 2) aim.tip = {tip.x, tip.z};
  // Beside the slice, a projected line would aim at what the needle misses.
  if (aim.tip && std::abs(way.y) < kInPlane) {
    const Vec3 end = tip + way * needle.length_mm;
    aim.line = {{tip.x, tip.z}, {end.x, end.z}};
  } else if (const double ahead_mm = -tip.y / way.y; ahead_mm > 0 && ahead_mm <= needle.length_mm) {
    const Vec3 crossed = tip + way * ahead_mm;
    aim.cross = {crossed.x, crossed.z};
  }
  return aim;
}

AimOverlay::AimOverlay(DisclosureModel& disclosure, LiveModel& live, AttemptControl& attempt,
                       views::UltrasoundView& image, QObject* parent)
    : QObject(parent), disclosure_(disclosure), live_(live), attempt_(attempt), image_(image) {
  connect(&live_, &LiveModel::pictureShown, this, [this] { show(); });
  connect(&attempt_, &AttemptControl::stateChanged, this, [this] { show(); });
  connect(&disclosure_, &DisclosureModel::changed, this, [this] { show(); });
}

void AimOverlay::setOn(bool isOn) {
  if (std::exchange(isOn_, isOn) == isOn) return;
  Q_EMIT switched(isOn);
  show();
}

void AimOverlay::show() {
  const auto& frame = live_.shown();
  const bool isGuided = attempt_.isRunning() && disclosure_.current().steps;
  image_.setNeedlePath(isOn_ && isGuided && frame && frame->needle
                           ? aimOf(*frame->needle, frame->patientFromProbe, *frame->setup)
                           : views::NeedlePathOverlay());
}

}  // namespace insonate::train
