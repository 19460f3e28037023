// The part of the session that moves the probe and tells what else is in the hands.
#include "TrainSession.h"

#include <insonate/simulator/ProbePose.h>
#include <insonate/simulator/TissueMechanics.h>
#include <insonate/ui/Text.h>

namespace insonate::train {

void TrainSession::connectHands() {
  connect(&hands_, &HandsControl::said, this, &TrainSession::say);
  connect(&hands_, &HandsControl::probeDriven, this, [this] {
    // Numbers and 3D follow; the image does by itself.
    if (!hands_.probeFollowsMouse()) control_.follow(hands_.drivenPose());
    Q_EMIT handMoved();
  });
  connect(&hands_, &HandsControl::pedalPressed, this, [this](int button) {
    if (button == 0) setFrozen(!frozen_);
  });
}

/// Once the image and the skin are there.
void TrainSession::giveHands() {
  if (!shown_ || !control_.ready()) return;
  giveProbe();
  hands_.setCase(tissueLabels_, control_.hand(), VesselNames(patient_->manifest, {}, control_.hand()->pose().offset));
}

void TrainSession::giveProbe() {
  static const TissueMechanics kUsual;  // its tables say nothing of a face
  if (control_.ready()) hands_.probeMoved(*control_.hand(), faceOf(probe_, kUsual).width_mm / 2);
}

ProbeHandState TrainSession::handState() const {
  return control_.hand() ? control_.hand()->state() : ProbeHandState{};
}

Transform TrainSession::pose() const {
  if (hands_.drivesProbe()) return hands_.drivenPose();
  return control_.hand() ? control_.hand()->pose() : Transform{};
}

bool TrainSession::isLive() {
  if (frozen_) say(tr("The image is frozen. Space makes it live again."));
  return !frozen_;
}

bool TrainSession::mayMove() {
  if (!isLive()) return false;
  if (!hands_.probeFollowsMouse())
    say(tr("A device holds the probe. Put mouse and keyboard into that hand under Devices to move it here."));
  return hands_.probeFollowsMouse();
}

void TrainSession::takeNeedle(NeedlePlane plane) {
  if (isLive()) hands_.takeNeedle(plane);
}

void TrainSession::toggleNeedle() {
  if (hands_.needleHand())
    hands_.layNeedleDown();
  else
    takeNeedle(hands_.needlePlane());
}

void TrainSession::moveNeedle(NeedleAxis axis, double amount) {
  if (isLive()) hands_.moveNeedle(axis, amount);
}

void TrainSession::typedNeedle(NeedleAxis axis, double value) {
  if (isLive()) hands_.setNeedle(axis, value);
}

void TrainSession::moved(HandMove result) {
  if (!result.done()) say(ui::qt(result.stopped));
  if (!control_.ready()) return;
  if (feed_.live() && !hands_.drivesProbe()) feed_.live()->setPose(pose());
  giveProbe();
  Q_EMIT handMoved();
}

void TrainSession::move(HandAxis axis, double amount) {
  if (mayMove()) moved(control_.move(axis, amount));
}

void TrainSession::slide(double lateral_mm, double elevation_mm) {
  if (mayMove()) moved(control_.slide(lateral_mm, elevation_mm));
}

void TrainSession::typed(HandAxis axis, double value) {
  control_.begin();
  if (mayMove()) moved(control_.set(axis, value));
  if (frozen_) Q_EMIT handMoved();  // The number goes back to what it was.
}

void TrainSession::moveTo(Vec3 patient_mm) {
  if (mayMove()) moved(control_.moveTo(patient_mm));
}

void TrainSession::placed(Vec3 patient_mm) {
  constexpr double kOnSkin_mm = 0.5;
  control_.begin();
  if (mayMove()) {
    moved(control_.moveTo(patient_mm));
    const double off_mm = norm(numbers().skin_mm - patient_mm);
    if (control_.ready() && off_mm > kOnSkin_mm)
      say(tr("That place is not on the skin; the probe is at the nearest skin, %1 mm away.").arg(off_mm, 0, 'f', 1));
  }
  Q_EMIT handMoved();  // Numbers that could not be reached go back.
}

void TrainSession::goTo(const StartPose& pose) {
  if (!mayShowAnatomy()) return;
  if (levelStart_) return say(tr("In a level, find the vein from where the attempt began (Home goes back there)."));
  control_.begin();
  if (mayMove()) moved(control_.setPose(pose));
}

void TrainSession::home() {
  if (!patient_ || !control_.ready()) return;
  control_.begin();
  if (mayMove()) moved(levelStart_ ? control_.setPose(*levelStart_) : control_.setPose(start_));
}

void TrainSession::beginAt(const ProbeHandState& state) {
  if (!control_.ready() || !hands_.probeFollowsMouse()) return;
  levelStart_ = state;
  control_.restore(state);
  moved({});
  history_.clear();
}

Vec3 TrainSession::targetNear_mm() const {
  const auto home = levelStart_ ? handAtStart() : std::nullopt;
  return home ? home->pose().offset : pose().offset;
}

std::optional<ProbeHand> TrainSession::handAtStart() const {
  if (!control_.hand()) return std::nullopt;
  ProbeHand hand = *control_.hand();
  if (const auto pose = patientFromProbe(start_.position_mm, start_.axial, start_.lateral)) hand.setPose(*pose);
  return hand;
}

}  // namespace insonate::train
