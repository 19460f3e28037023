#include "hands/HandsLoop.h"

#include <insonate/procedure/AttemptScore.h>

#include <utility>

namespace insonate {

HandsSession::HandsSession(std::shared_ptr<haptics::HidBus> bus) : impl_(std::make_unique<Impl>(std::move(bus))) {}
HandsSession::~HandsSession() = default;

DeviceHub& HandsSession::devices() {
  std::call_once(impl_->looking, [this] { impl_->hub.start(); });
  return impl_->hub;
}

void HandsSession::setCase(std::shared_ptr<const LabelMap> labels, const ProbeHand* hand) {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->labels = std::move(labels);
    impl_->skin = hand ? hand->skin_ : nullptr;
    impl_->forgetTissue();
    if (impl_->labels && hand) impl_->wantTissue(hand->pose());
  }
  impl_->wake();
}

void HandsSession::setVessels(VesselNames vessels) {
  const std::lock_guard lock(impl_->mutex);
  impl_->vessels = std::move(vessels);
}

void HandsSession::setImaging(LiveImaging* imaging) {
  const std::lock_guard lock(impl_->mutex);
  impl_->show(imaging);
}

void HandsSession::setAttempt(std::shared_ptr<LiveAttempt> attempt) {
  const std::lock_guard lock(impl_->mutex);
  impl_->attempt = std::move(attempt);
  if (impl_->servo) impl_->servo->setListener(impl_->attempt);
}

void HandsSession::assignDevice(Hand hand, std::shared_ptr<HapticDevice> device, HandSetup setup) {
  impl_->assignDevice(hand, std::move(device), std::move(setup));
}

void HandsSession::putMouse(Hand hand, const Transform& patientFromTool) {
  impl_->placeMouse(hand, patientFromTool);
  impl_->mice[hand]->setConnected(true);
  impl_->assignDevice(hand, impl_->mice[hand], {});
  const std::lock_guard lock(impl_->mutex);
  impl_->mouseAt[hand] = patientFromTool;
}

void HandsSession::moveByMouse(Hand hand, const Transform& patientFromTool) {
  const std::lock_guard lock(impl_->mutex);
  impl_->moveByMouse(hand, patientFromTool);
}

std::shared_ptr<HapticDevice> HandsSession::assignedDevice(Hand hand) const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->devices[hand];
}

bool HandsSession::isMouse(Hand hand) const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->isMouse(hand);
}

bool HandsSession::followsMouse(Hand hand) const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->isMouse(hand) || impl_->simulated(hand);
}

HandSetup HandsSession::setupOf(Hand hand) const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->setup.hands[hand];
}

void HandsSession::holdNeedle(bool held) {
  impl_->holdNeedle(held);
}

void HandsSession::setPedal(std::shared_ptr<HapticDevice> pedal) {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->pedal = std::move(pedal);
    impl_->pedalDown = ~0U;  // a pedal that is already down does not count as pressed
  }
  impl_->wake();
}

std::uint32_t HandsSession::takePresses() {
  const std::lock_guard lock(impl_->mutex);
  return std::exchange(impl_->presses, 0U);
}

void HandsSession::testForce(Hand hand, Vec3 force_N) {
  impl_->testForce(hand, force_N);
}

ServoSnapshot HandsSession::snapshot() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->servo ? impl_->servo->latest() : ServoSnapshot{};
}

std::vector<NeedleEvent> HandsSession::takeEvents() {
  const std::lock_guard lock(impl_->mutex);
  return impl_->servo ? impl_->servo->takeEvents() : std::vector<NeedleEvent>{};
}

std::string HandsSession::vesselAt(Label label, Vec3 patient_mm) const {
  const std::lock_guard lock(impl_->mutex);
  const Transform restFromPatient = impl_->frame ? impl_->frame->press.restFromPatient : Transform{};
  const std::span<const CenterLine> veins = impl_->veins ? std::span(*impl_->veins) : std::span<const CenterLine>{};
  AttemptEvent there;
  there.wall = label;
  there.vessel = impl_->vessels.vesselAt(label, restFromPatient * patient_mm, veins);
  return vesselName(there, impl_->vessels.names());
}

RealTimeRights HandsSession::rights() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->servo ? impl_->servo->rights() : RealTimeRights{};
}

TickTiming HandsSession::timing() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->servo ? impl_->servo->timing() : TickTiming{};
}

bool HandsSession::tissueReady() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->grid != nullptr;
}

}  // namespace insonate
