#include "hands/HapticLoop.h"

#include <insonate/procedure/AttemptScore.h>

#include <utility>

namespace insonate {

HapticSession::HapticSession(std::shared_ptr<haptics::HidBus> bus) : impl_(std::make_unique<Impl>(std::move(bus))) {}
HapticSession::~HapticSession() = default;

DeviceHub& HapticSession::devices() {
  std::call_once(impl_->looking, [this] { impl_->hub.start(); });
  return impl_->hub;
}

void HapticSession::setCase(std::shared_ptr<const LabelMap> labels, const ProbePlacement* hand) {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->labels = std::move(labels);
    impl_->skin = hand ? hand->skin_ : nullptr;
    impl_->forgetTissue();
    if (impl_->labels && hand) impl_->wantTissue(hand->pose());
  }
  impl_->wake();
}

void HapticSession::setVessels(VesselLocator vessels) {
  const std::lock_guard lock(impl_->mutex);
  impl_->vessels = std::move(vessels);
}

void HapticSession::setImaging(LiveImaging* imaging) {
  const std::lock_guard lock(impl_->mutex);
  impl_->show(imaging);
}

void HapticSession::setAttempt(std::shared_ptr<LiveAttempt> attempt) {
  const std::lock_guard lock(impl_->mutex);
  if (!attempt) impl_->showAttempt(nullptr);
  impl_->attempt = std::move(attempt);
  if (impl_->servo) impl_->servo->setListener(impl_->attempt);
}

void HapticSession::assignDevice(HapticTool hand, std::shared_ptr<HapticDevice> device, ToolSetup setup) {
  impl_->assignDevice(hand, std::move(device), std::move(setup));
}

void HapticSession::assignMouse(HapticTool hand, const Transform& patientFromTool) {
  impl_->placeMouse(hand, patientFromTool);
  impl_->mice[hand]->setConnected(true);
  impl_->assignDevice(hand, impl_->mice[hand], {});
  const std::lock_guard lock(impl_->mutex);
  impl_->mouseAt[hand] = patientFromTool;
}

void HapticSession::moveByMouse(HapticTool hand, const Transform& patientFromTool) {
  const std::lock_guard lock(impl_->mutex);
  impl_->moveByMouse(hand, patientFromTool);
}

std::shared_ptr<HapticDevice> HapticSession::assignedDevice(HapticTool hand) const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->devices[hand];
}

bool HapticSession::isMouseAssigned(HapticTool hand) const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->isMouseAssigned(hand);
}

bool HapticSession::followsMouse(HapticTool hand) const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->isMouseAssigned(hand) || impl_->simulated(hand);
}

ToolSetup HapticSession::setupOf(HapticTool hand) const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->setup.tools[hand];
}

void HapticSession::setNeedleFixed(bool held) {
  impl_->setNeedleFixed(held);
}

void HapticSession::setFreeHand(FreeHand hand, const WireGrip& wire) {
  impl_->setFreeHand(hand, wire);
}

void HapticSession::setPedal(std::shared_ptr<HapticDevice> pedal) {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->pedal = std::move(pedal);
    impl_->pedalDown = ~0U;  // a pedal that is already down does not count as pressed
  }
  impl_->wake();
}

std::uint32_t HapticSession::takePedalPresses() {
  const std::lock_guard lock(impl_->mutex);
  return std::exchange(impl_->presses, 0U);
}

void HapticSession::testForce(HapticTool hand, Vec3 force_N) {
  impl_->testForce(hand, force_N);
}

ServoSnapshot HapticSession::snapshot() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->servo ? impl_->servo->latest() : ServoSnapshot{};
}

std::vector<NeedleEvent> HapticSession::takeEvents() {
  const std::lock_guard lock(impl_->mutex);
  return impl_->servo ? impl_->servo->takeEvents() : std::vector<NeedleEvent>{};
}

std::string HapticSession::vesselAt(Label label, Vec3 patient_mm) const {
  const std::lock_guard lock(impl_->mutex);
  const Transform restFromPatient = impl_->frame ? impl_->frame->press.restFromPatient : Transform{};
  const std::span<const CenterLine> veins = impl_->veins ? std::span(*impl_->veins) : std::span<const CenterLine>{};
  AttemptEvent there;
  there.wall = label;
  there.vessel = impl_->vessels.vesselAt(label, restFromPatient * patient_mm, veins);
  return vesselName(there, impl_->vessels.names());
}

RealTimeRights HapticSession::realTimeRights() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->servo ? impl_->servo->realTimeRights() : RealTimeRights{};
}

TickTiming HapticSession::tickTiming() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->servo ? impl_->servo->tickTiming() : TickTiming{};
}

bool HapticSession::isTissueGridReady() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->grid != nullptr;
}

}  // namespace insonate
