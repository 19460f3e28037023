#include "HapticControl.h"

#include "NeedleWords.h"

#include <insonate/cases/HeartDirection.h>
#include <insonate/haptics/SimulatedDevice.h>
#include <insonate/haptics/VendorKit.h>
#include <insonate/ui/Text.h>

#include <QSettings>
#include <algorithm>
#include <cmath>
#include <utility>

namespace insonate::train {
namespace {

constexpr int kPoll_ms = 16, kSlow_ms = 500;
/// Force above which the other tool counts as pushing a needle that is outside.
constexpr double kTouch_N = 0.3;
constexpr double kStart_mm = 5;  // off the skin
/// Bits of DeviceState::buttons.
constexpr std::uint32_t kTurnButton = 1;
constexpr double kStill_deg = 0.01;

bool sameNeedle(const NeedleShown& a, const NeedleShown& b) {
  const NeedleState &s = a.state, &t = b.state;
  return a.patientFromNeedle == b.patientFromNeedle && s.inBody == t.inBody && s.in == t.in && s.onBone == t.onBone &&
         s.tenting == t.tenting && std::abs(s.axial_N - t.axial_N) < 0.01 && std::abs(s.tent_mm - t.tent_mm) < 0.01 &&
         std::abs(s.depth_mm - t.depth_mm) < 0.01;
}

}  // namespace

HapticControl::HapticControl(QObject* parent)
    : QObject(parent), session_(std::make_unique<HapticSession>(allDevices())) {
  timer_.setInterval(kPoll_ms);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, [this] { look(); });
  slow_.setInterval(kSlow_ms);
  connect(&slow_, &QTimer::timeout, this, [this] { checkDevices(); });
}

HapticControl::~HapticControl() = default;

void HapticControl::setCase(std::shared_ptr<const PatientCase> patient, std::shared_ptr<const LabelMap> labels,
                            const ProbePlacement* hand) {
  removeNeedle();
  if (labels) session_->devices();  // begins to look for them
  patient_ = std::move(patient), labels_ = std::move(labels);
  probe_ = hand ? std::optional(*hand) : std::nullopt;
  if (hand) onOutline_ = hand->pose();
  session_->setVessels(patient_ && hand ? VesselLocator(patient_->manifest, {}, hand->pose().offset) : VesselLocator());
  session_->setCase(labels_, hand);
  apply();
}

void HapticControl::setWatched(bool watched) {
  if (std::exchange(watched_, watched) != watched) apply();
}

void HapticControl::probeMoved(const ProbePlacement& hand, double halfWidth_mm) {
  probe_ = hand;
  halfWidth_mm_ = halfWidth_mm;
  session_->moveByMouse(kProbeTool, hand.pose());
}

void HapticControl::setAttempt(std::shared_ptr<LiveAttempt> attempt) {
  attempted_ = attempt != nullptr;
  session_->setAttempt(std::move(attempt));
  apply();
}

void HapticControl::setSilent(bool silent) {
  if (std::exchange(silent_, silent) != silent) Q_EMIT needleChanged();
}

bool HapticControl::drivesProbe() const {
  return put_[kProbeTool] && !session_->isMouseAssigned(kProbeTool);
}

bool HapticControl::probeFollowsMouse() const {
  return !drivesProbe() || session_->followsMouse(kProbeTool);
}

std::shared_ptr<HapticDevice> HapticControl::deviceOf(const QString& id) {
  for (const auto& device : session_->devices().devices())
    if (device->info().id == id.toStdString()) return device;
  return nullptr;
}

Transform HapticControl::startOf(HapticTool hand) const {
  if (hand == kProbeTool) return probe_->pose();
  if (wish_) return wish_->patientFromNeedle();
  return newNeedle().patientFromNeedle();
}

/// Points toward the heart along the vein under the probe, so that a wire through the needle leads there.
NeedlePlacement HapticControl::newNeedle() const {
  constexpr double kVeinDepth_mm = 15;
  const auto toward =
      patient_ ? veinTowardHeart(patient_->manifest, probe_->pose() * Vec3{0, 0, kVeinDepth_mm}) : std::nullopt;
  return NeedlePlacement::makeBeside(*probe_, halfWidth_mm_, plane_, toward);
}

bool HapticControl::isOnDesk(const HapticDevice& device) const {
  return onDesk_.contains(int(device.info().kind));
}

ToolSetup HapticControl::setupFor(HapticTool hand, const HapticDevice& device, const HandMapping& mapping) const {
  return isOnDesk(device) ? setupOnDesk(mapping, onOutline_) : setupOf(mapping, startOf(hand));
}

/// Puts the chosen device into a hand if it holds another one.
void HapticControl::put(HapticTool hand) {
  const bool ready = labels_ && probe_;
  std::shared_ptr<HapticDevice> device = choice_.isMouseAssigned(hand) ? nullptr : deviceOf(choice_.device(hand));
  const bool simulated = dynamic_cast<SimulatedDevice*>(device.get()) != nullptr;
  // A real needle is there as soon as its device is; that of mouse and keys is taken up. Nobody feels a force without
  // looking.
  const bool taken = hand == kProbeTool ? device || needle_ || wish_ || attempted_ : wish_ || (device && !simulated);
  if (!ready || !taken || (device && !simulated && !watched_)) {
    if (!session_->assignedDevice(hand)) return;
    put_[hand] = nullptr;
    session_->assignDevice(hand, nullptr, {});
    Q_EMIT handsChanged();
    return;
  }
  if (!choice_.isMouseAssigned(hand) && !device) return;  // it may come back
  if (session_->assignedDevice(hand) && (device ? put_[hand] == device : session_->isMouseAssigned(hand))) return;
  const Transform start = startOf(hand);
  if (device) {
    HandMapping mapping = choice_.mapping(choice_.device(hand));
    DeviceState state;
    if (simulated && device->pollState(state)) mapping.begin = state.deviceFromStylus;
    const DeviceKind kind = device->info().kind;
    beginsHere_[hand] = (kind == DeviceKind::kCamera || kind == DeviceKind::kTracker) && !isOnDesk(*device) &&
                        !choice_.hasMapping(choice_.device(hand));
    session_->assignDevice(hand, device, setupFor(hand, *device, mapping));
    session_->moveByMouse(hand, start);
  } else {
    session_->assignMouse(hand, start);
  }
  put_[hand] = session_->assignedDevice(hand);
  Q_EMIT handsChanged();
}

void HapticControl::apply() {
  put(kNeedleTool);
  put(kProbeTool);
  if (auto pedal = choice_.pedal().isEmpty() ? nullptr : deviceOf(choice_.pedal()); pedal != pedalDevice_)
    session_->setPedal(pedalDevice_ = pedal);
  const bool active = session_->assignedDevice(kProbeTool) || session_->assignedDevice(kNeedleTool) || pedalDevice_;
  if (active && !timer_.isActive()) clock_.start(), timer_.start();
  if (!active) timer_.stop();
  const bool waits = choice_.isAny();
  if (waits != slow_.isActive()) waits ? slow_.start() : slow_.stop();
  if (!session_->assignedDevice(kNeedleTool) && std::exchange(needle_, std::nullopt)) Q_EMIT needleChanged();
}

void HapticControl::checkDevices() {
  apply();
  for (const DeviceEvent& event : session_->devices().takeEvents()) {
    const QString id = QString::fromStdString(event.device);
    if (event.error && choice_.has(id)) Q_EMIT messageReported(QString::fromStdString(event.text));
    Q_EMIT deviceEvent(event);
  }
  tellAdvice();
}

/// Says at once when a hand is lost from sight. The panel shows other advice, which may change with every motion.
void HapticControl::tellAdvice() {
  for (const HapticTool hand : {kProbeTool, kNeedleTool}) {
    const auto device = choice_.isMouseAssigned(hand) ? nullptr : deviceOf(choice_.device(hand));
    const DeviceQuality quality =
        device && device->phase() == DevicePhase::kStreaming ? device->quality() : DeviceQuality{};
    const QString advice = quality.quality <= 0 ? ui::qt(quality.advice) : QString();
    if (std::exchange(advice_[hand], advice) != advice && !advice.isEmpty())
      Q_EMIT messageReported(tr("%1: %2").arg(ui::qt(device->info().name), advice));
  }
}

void HapticControl::look() {
  const double step_s = std::min(0.1, double(clock_.restart()) / 1000);
  const ServoSnapshot now = session_->snapshot();
  if (wish_) advanceTowardTarget(now, step_s);
  for (const HapticTool hand : {kProbeTool, kNeedleTool})
    if (beginsHere_[hand] && now.present[hand] && std::exchange(beginsHere_[hand], false)) beginHere(hand);
  follow(now);
  if (now.present[kNeedleTool] && !session_->isMouseAssigned(kNeedleTool)) checkButtons(now.states[kNeedleTool]);
  for (const NeedleEvent& event : session_->takeEvents()) {
    Q_EMIT needleMet(event);
    if (!silent_) Q_EMIT messageReported(findingText(event, vesselAt(*session_, event.wall, event.tip_mm)));
  }
  for (std::uint32_t down = session_->takePedalPresses(), button = 0; down; down >>= 1, ++button)
    if (down & 1) Q_EMIT pedalPressed(int(button));
}

void HapticControl::checkButtons(const DeviceState& now) {
  const DeviceState before = std::exchange(stylus_, now);
  if (isInstrumentInHand_) return;
  if ((now.buttons ^ before.buttons) & kGripButton) Q_EMIT aspirateButtonChanged(now.buttons & kGripButton);
  if (!(now.buttons & before.buttons & kTurnButton)) return;
  // For small turns: the sum of the axes' cross products is twice the turn.
  Vec3 twice;
  for (int i = 0; i < 3; ++i)
    twice = twice + cross(before.deviceFromStylus.linear.column[i], now.deviceFromStylus.linear.column[i]);
  const Vec3 turn_deg = twice * (0.5 * 180 / 3.14159265358979);
  // The patient goes along with the hand: the view goes the other way round.
  if (norm(turn_deg) > kStill_deg) Q_EMIT anatomyTurned(-turn_deg.y, turn_deg.x);
}

void HapticControl::follow(const ServoSnapshot& now) {
  if (drivesProbe() && now.present[kProbeTool]) {
    const Transform& held = now.output.tools[kProbeTool].patientFromTool;
    if (std::exchange(driven_, held) != held) Q_EMIT probeDriven();
  }
  std::optional<NeedleShown> shown;
  if (now.present[kNeedleTool])
    shown = NeedleShown{now.output.tools[kNeedleTool].patientFromShown, now.output.needle};
  else if (wish_)
    shown = NeedleShown{wish_->patientFromNeedle(), {}};
  if (shown && needle_ && sameNeedle(*shown, *needle_)) return;
  if (!shown && !needle_) return;
  const bool came = shown.has_value() != needle_.has_value();
  needle_ = shown;
  Q_EMIT needleChanged();
  if (came) apply();  // the probe is there for the needle to touch
}

/// Mouse and keys push on until something stops the needle: bone, or the probe.
void HapticControl::advanceTowardTarget(const ServoSnapshot& now, double step_s) {
  const double left_mm = advance_mm_ - wish_->state().advance_mm;
  if (left_mm == 0) return;
  const ToolOutput& out = now.output.tools[kNeedleTool];
  const NeedleState& state = now.output.needle;
  const bool probe = !state.inBody && !state.tenting && norm(out.wanted_N) > kTouch_N;
  if (left_mm > 0 && now.present[kNeedleTool] && (state.onBone || probe)) {
    advance_mm_ = wish_->state().advance_mm;
    if (probe) Q_EMIT messageReported(tr("The needle touches the probe. Move the needle or the probe aside."));
    return;
  }
  const double max_mm = kAdvance_mmPerS * step_s;
  wish_->advance(std::clamp(left_mm, -max_mm, max_mm));
  if (std::abs(left_mm) <= max_mm) advance_mm_ = wish_->state().advance_mm;
  targetChanged();
}

void HapticControl::targetChanged() {
  session_->moveByMouse(kNeedleTool, wish_->patientFromNeedle());
}

void HapticControl::takeNeedle(NeedlePlane plane) {
  if (!labels_ || !probe_) return Q_EMIT messageReported(tr("The needle cannot be used yet: no patient is loaded."));
  plane_ = plane;
  if (!choice_.isMouseAssigned(kNeedleTool) &&
      !dynamic_cast<SimulatedDevice*>(deviceOf(choice_.device(kNeedleTool)).get()))
    return Q_EMIT messageReported(tr("A device controls the needle."));
  if (wish_) removeNeedle();
  wish_ = newNeedle();
  advance_mm_ = -kStart_mm;
  apply();
  follow(session_->snapshot());
  constexpr double kInPlane_mm = 0.1;
  if (plane == NeedlePlane::InPlane && wish_->offPlane_mm(probe_->pose()) > kInPlane_mm)
    return Q_EMIT messageReported(
        tr("The needle is not in-plane: there is no skin beside the probe, or the skin faces away from the needle. "
           "Move the probe, then put the needle away and take it up again (press I twice)."));
  Q_EMIT messageReported(
      session_->isTissueGridReady()
          ? tr("The needle is beside the probe, at 20 degrees to the skin. Alt+W makes the needle steeper, "
               "Page Down advances it, Page Up withdraws it.")
          : tr("You can move the needle; its contact with the patient is still being computed."));
}

void HapticControl::setHeld(bool held) {
  if (wish_) advance_mm_ = wish_->state().advance_mm;
  isHeld_ = held;
  session_->setNeedleFixed(isHeld_ || isInstrumentInHand_);
}

void HapticControl::setInstrumentInHand(bool isInHand) {
  if (isInHand && (stylus_.buttons & kGripButton)) Q_EMIT aspirateButtonChanged(false);
  isInstrumentInHand_ = isInHand;
  session_->setNeedleFixed(isHeld_ || isInstrumentInHand_);
}

void HapticControl::removeNeedle() {
  if (!std::exchange(wish_, std::nullopt)) return;
  apply();
  Q_EMIT needleChanged();
}

void HapticControl::tell(MoveResult move) {
  if (!move.done()) Q_EMIT messageReported(ui::qt(move.stopped));
  targetChanged();
  Q_EMIT needleChanged();
}

void HapticControl::moveNeedle(NeedleAxis axis, double amount) {
  if (!wish_)
    return Q_EMIT messageReported(needle_ ? tr("A device controls the needle.") : tr("Take up the needle first (I)."));
  switch (axis) {
    case NeedleAxis::Lateral:
      return tell(wish_->slide(probe_->pose(), amount, 0));
    case NeedleAxis::Elevation:
      return tell(wish_->slide(probe_->pose(), 0, amount));
    case NeedleAxis::Heading:
      return tell(wish_->turn(amount));
    case NeedleAxis::Angle:
      return tell(wish_->tilt(amount));
    case NeedleAxis::Bevel:
      return tell(wish_->rotateBevel(amount));
    case NeedleAxis::Advance: {
      const double wanted_mm = advance_mm_ + amount;
      advance_mm_ = std::clamp(wanted_mm, -NeedlePlacement::kMaxOff_mm, NeedlePlacement::kLength_mm);
      if (wanted_mm != advance_mm_)
        Q_EMIT messageReported(amount > 0 ? tr("The needle is inserted up to its hub (70 mm).")
                                          : tr("The needle does not touch the skin."));
      return Q_EMIT needleChanged();
    }
  }
}

void HapticControl::setNeedle(NeedleAxis axis, double value) {
  if (!wish_) return moveNeedle(axis, 0);
  const NeedlePlacementState& now = wish_->state();
  switch (axis) {
    case NeedleAxis::Heading:
      return moveNeedle(axis, std::remainder(value - wish_->heading_deg(), 360));
    case NeedleAxis::Angle:
      return moveNeedle(axis, value - now.angle_deg);
    case NeedleAxis::Bevel:
      return moveNeedle(axis, value - now.bevel_deg);
    default:
      return moveNeedle(NeedleAxis::Advance, value - advance_mm_);
  }
}

void HapticControl::needleTo(Vec3 patient_mm) {
  if (wish_) tell(wish_->moveTo(patient_mm));
}

void HapticControl::assign(HapticTool hand, const QString& device) {
  if (choice_.device(hand) == device) return;
  if (hand == kNeedleTool) removeNeedle();
  const HapticTool other = hand == kProbeTool ? kNeedleTool : kProbeTool;
  const QString others = choice_.device(other);
  choice_.setDevice(hand, device);
  if (choice_.device(other) != others) leave(other);
  leave(hand);
  apply();
  Q_EMIT handsChanged();
}

/// Takes the present device out of a hand.
void HapticControl::leave(HapticTool hand) {
  if (hand == kNeedleTool) removeNeedle();
  put_[hand] = nullptr;
  if (session_->assignedDevice(hand)) session_->assignDevice(hand, nullptr, {});
}

std::string HapticControl::kindOfHand(HapticTool hand) {
  const auto device = deviceOf(choice_.device(hand));
  if (!device) return "mouse";
  if (dynamic_cast<SimulatedDevice*>(device.get())) return "simulated";
  return std::string(nameOf(device->info().kind));
}

void HapticControl::setOnDesk(DeviceKind kind, bool isOnDesk) {
  isOnDesk ? void(onDesk_.insert(int(kind))) : void(onDesk_.remove(int(kind)));
  for (const HapticTool hand : {kProbeTool, kNeedleTool})
    if (put_[hand] && put_[hand]->info().kind == kind) leave(hand);
  apply();
  Q_EMIT handsChanged();
}

void HapticControl::assignPedal(const QString& device) {
  choice_.setPedal(device);
  apply();
  Q_EMIT handsChanged();
}

void HapticControl::setMapping(const QString& device, const HandMapping& mapping) {
  const bool otherSide = choice_.mapping(device).stand != mapping.stand;
  choice_.setMapping(device, mapping);
  for (const HapticTool hand : {kProbeTool, kNeedleTool})
    if (choice_.device(hand) == device && !device.isEmpty() && session_->assignedDevice(hand) == put_[hand] &&
        put_[hand]) {
      // Forces at once; the tool goes on from where it is, or, seen from another side, from where it began.
      ToolSetup now = otherSide ? setupFor(hand, *put_[hand], mapping) : session_->setupOf(hand);
      now.gain = mapping.gain, now.userMaxForce_N = mapping.userMaxForce_N, now.apart_mm = mapping.apart_mm;
      session_->assignDevice(hand, put_[hand], now);
    }
  Q_EMIT handsChanged();
}

void HapticControl::beginHere(HapticTool hand) {
  const ServoSnapshot now = session_->snapshot();
  if (!labels_ || !probe_ || choice_.isMouseAssigned(hand) || !now.present[hand])
    return Q_EMIT messageReported(
        tr("First assign a device to this hand, and wait until the device reports its position."));
  if (put_[hand] && isOnDesk(*put_[hand]))
    return Q_EMIT messageReported(
        tr("The place of this hand is that of the registered desk. To move the place, set the desk again."));
  HandMapping mapping = choice_.mapping(choice_.device(hand));
  mapping.begin = now.states[hand].deviceFromStylus;
  choice_.setMapping(choice_.device(hand), mapping);
  session_->assignDevice(hand, put_[hand], setupOf(mapping, startOf(hand)));
  Q_EMIT handsChanged();
  Q_EMIT messageReported(hand == kProbeTool
                             ? tr("The device's present pose now corresponds to the probe's pose in the image.")
                             : tr("The device's present pose now corresponds to a needle beside the probe."));
}

void HapticControl::save(QSettings& settings) const {
  choice_.save(settings);
  settings.setValue("needleAcross", plane_ == NeedlePlane::OutOfPlane);
}

void HapticControl::restore(QSettings& settings) {
  choice_.restore(settings);
  plane_ = settings.value("needleAcross", false).toBool() ? NeedlePlane::OutOfPlane : NeedlePlane::InPlane;
  apply();
  Q_EMIT handsChanged();
}

}  // namespace insonate::train
