#include "ProbeMotion.h"

#include "CaseModel.h"
#include "Disclosure.h"
#include "HapticControl.h"
#include "History.h"
#include "ImagingModel.h"
#include "LiveModel.h"
#include "StatusLine.h"

#include <insonate/simulator/ProbePose.h>
#include <insonate/simulator/TissueMechanics.h>
#include <insonate/ui/Text.h>

#include <utility>

namespace insonate::train {

ProbeMotion::ProbeMotion(const Models& models, QObject* parent) : QObject(parent), models_(models) {
  connectCase();
  connectHands();
  control_.setGestureBegan([this](const ProbePlacementState& before) { rememberMove(before); });
  models_.status.setState([this] { return stateInWords(); });
}

void ProbeMotion::connectCase() {
  const CaseModel* patientCase = &models_.patientCase;
  connect(patientCase, &CaseModel::emptied, this, [this] {
    control_.setHand(std::nullopt);
    models_.hands.setCase(nullptr, nullptr, nullptr);
    models_.history.clear();
    releaseStart();
    unplaced_.reset();
  });
  connect(patientCase, &CaseModel::handMade, this, [this](const ProbePlacement& hand) {
    control_.setHand(hand);
    giveHands();
    Q_EMIT handMoved();
  });
  connect(patientCase, &CaseModel::startMissing, this, [this](const ProbePlacement& hand) {
    unplaced_ = hand;
    Q_EMIT placingChanged();
  });
  connect(&models_.live, &LiveModel::firstShown, this, [this] { giveHands(); });
  connect(&models_.imaging, &ImagingModel::setupChanged, this, [this] { giveProbe(); });
}

void ProbeMotion::connectHands() {
  HapticControl& hands = models_.hands;
  connect(&hands, &HapticControl::messageReported, &models_.status, &StatusLine::showMessage);
  connect(&hands, &HapticControl::probeDriven, this, [this] {
    // Numbers and 3D follow; the image does by itself.
    if (!models_.hands.probeFollowsMouse()) control_.follow(models_.hands.drivenPose());
    Q_EMIT handMoved();
  });
  connect(&models_.disclosure, &DisclosureModel::changed, this,
          [this] { models_.hands.setSilent(!models_.disclosure.current().anatomy); });
}

std::optional<QString> ProbeMotion::stateInWords() const {
  if (!models_.patientCase.patient()) return QString();
  if (!models_.live.failure().empty()) return QString::fromStdString(models_.live.failure());
  if (unplaced_) return tr("Place the probe: click \"Place probe on skin\", or click on the skin in the 3D view.");
  if (!models_.live.shown()) return tr("Building the first image.");
  if (models_.live.isFrozen()) return tr("The image is frozen. Comma and Period show earlier and later images.");
  return std::nullopt;
}

/// Once the image and the skin are there.
void ProbeMotion::giveHands() {
  if (!models_.live.shown() || !control_.ready()) return;
  giveProbe();
  models_.hands.setCase(models_.patientCase.patient(), models_.patientCase.tissueLabels(), control_.hand());
}

void ProbeMotion::giveProbe() {
  static const TissueMechanics kUsual;  // its tables say nothing of a face
  if (control_.ready())
    models_.hands.probeMoved(*control_.hand(), probeFaceOf(models_.imaging.probe(), kUsual).width_mm / 2);
}

ProbePlacementState ProbeMotion::state() const {
  return control_.hand() ? control_.hand()->state() : ProbePlacementState{};
}

Transform ProbeMotion::pose() const {
  if (models_.hands.drivesProbe()) return models_.hands.drivenPose();
  return control_.hand() ? control_.hand()->pose() : Transform{};
}

bool ProbeMotion::mayMove() {
  if (!models_.live.checkLive()) return false;
  if (!models_.disclosure.current().otherPlaces) {
    models_.status.showMessage(tr("The test has not begun. Start it (Ctrl+Return); then the probe can be moved."));
    return false;
  }
  if (!models_.hands.probeFollowsMouse())
    models_.status.showMessage(
        tr("A device controls the probe. To move the probe here, click Devices and choose \"mouse and keyboard\" for "
           "the probe."));
  return models_.hands.probeFollowsMouse();
}

void ProbeMotion::moved(MoveResult result) {
  if (!result.done()) models_.status.showMessage(ui::qt(result.stopped));
  if (!control_.ready()) return;
  if (!models_.hands.drivesProbe()) models_.live.setPose(pose());
  giveProbe();
  Q_EMIT handMoved();
}

void ProbeMotion::move(HandAxis axis, double amount) {
  if (mayMove()) moved(control_.move(axis, amount));
}

void ProbeMotion::slide(double lateral_mm, double elevation_mm) {
  if (mayMove()) moved(control_.slide(lateral_mm, elevation_mm));
}

void ProbeMotion::typed(HandAxis axis, double value) {
  control_.begin();
  if (mayMove()) moved(control_.set(axis, value));
  if (models_.live.isFrozen()) Q_EMIT handMoved();  // The number goes back to what it was.
}

void ProbeMotion::moveTo(Vec3 patient_mm) {
  if (mayMove()) moved(control_.moveTo(patient_mm));
}

void ProbeMotion::placed(Vec3 patient_mm) {
  constexpr double kOnSkin_mm = 0.5;
  control_.begin();
  if (mayMove()) {
    moved(control_.moveTo(patient_mm));
    const double off_mm = norm(numbers().skin_mm - patient_mm);
    if (control_.ready() && off_mm > kOnSkin_mm)
      models_.status.showMessage(
          tr("That place is not on the skin. The probe was placed on the nearest skin, %1 mm away.")
              .arg(off_mm, 0, 'f', 1));
  }
  Q_EMIT handMoved();  // Numbers that could not be reached go back.
}

void ProbeMotion::goTo(const StartPose& pose) {
  if (!models_.disclosure.mayShowAnatomy()) return;
  if (levelStart_)
    return models_.status.showMessage(
        tr("Listed positions cannot be used in a level: search for the vein from the start position of the attempt "
           "(Home returns the probe to it)."));
  control_.begin();
  if (mayMove()) moved(control_.setPose(pose));
}

void ProbeMotion::home() {
  if (!models_.patientCase.patient() || !control_.ready()) return;
  control_.begin();
  if (mayMove()) moved(levelStart_ ? control_.setPose(*levelStart_) : control_.setPose(models_.patientCase.start()));
}

void ProbeMotion::beginAt(const ProbePlacementState& state) {
  if (!control_.ready() || !models_.hands.probeFollowsMouse()) return;
  levelStart_ = state;
  control_.restore(state);
  moved({});
  models_.history.clear();
  Q_EMIT startHeldChanged();
}

void ProbeMotion::releaseStart() {
  if (std::exchange(levelStart_, std::nullopt)) Q_EMIT startHeldChanged();
}

Vec3 ProbeMotion::targetNear_mm() const {
  const auto home = levelStart_ ? handAtStart() : std::nullopt;
  return home ? home->pose().offset : pose().offset;
}

std::optional<ProbePlacement> ProbeMotion::handAtStart() const {
  if (!control_.hand()) return std::nullopt;
  ProbePlacement hand = *control_.hand();
  const StartPose& start = models_.patientCase.start();
  if (const auto pose = patientFromProbe(start.position_mm, start.axial, start.lateral)) hand.setPose(*pose);
  return hand;
}

void ProbeMotion::rememberMove(const ProbePlacementState& before) {
  const auto exchange = [this, other = before]() mutable {
    const ProbePlacementState now = state();
    control_.restore(std::exchange(other, now));
    moved({});
  };
  models_.history.add(tr("probe movement"), exchange, {}, [this] { return mayMove(); });
}

void ProbeMotion::placeOnSkin() {
  if (!unplaced_) return;
  control_.setHand(std::exchange(unplaced_, std::nullopt));
  models_.patientCase.setStart(toStartPose(pose()));
  Q_EMIT placingChanged();
  Q_EMIT handMoved();
  models_.status.showMessage(
      tr("The probe was placed on the front of the patient. Drag on the skin in the 3D view to move the probe."));
}

}  // namespace insonate::train
