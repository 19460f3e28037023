#pragma once

#include <insonate/haptics/DeviceHub.h>
#include <insonate/haptics/InputHand.h>
#include <insonate/haptics/ServoThread.h>
#include <insonate/image/Volume.h>
#include <insonate/simulator/LiveImaging.h>
#include <insonate/simulator/ProbeHand.h>
#include <insonate/simulator/VesselNames.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace insonate {

class LiveAttempt;

/// Two hands on a patient: devices, the servo that computes their forces, and the tissue that the servo knows. While a
/// hand holds something, a thread shows the servo 60 times a second the tissue before the probe's face and around the
/// needle's tip, and moves the live image with the held probe. An empty hand costs nothing.
///
/// Every member may be called from any thread; none waits longer than a fraction of a millisecond but put() and the
/// destructor, which may wait for a tick and for a step of the tissue's preparation, a tenth of a second.
class HandsSession {
 public:
  /// Devices of `bus`; the built-in `measured` needle. Looks for devices from the first call of devices() on.
  explicit HandsSession(std::shared_ptr<haptics::HidBus> bus);
  /// Releases all devices after a last zero force.
  ~HandsSession();
  HandsSession(const HandsSession&) = delete;
  HandsSession& operator=(const HandsSession&) = delete;

  DeviceHub& devices();

  /// The patient's tissues, and a hand on that patient's skin; none for none. The needle's tissue is prepared in the
  /// background round the probe, and again where the hands have gone elsewhere with the needle outside.
  void setCase(std::shared_ptr<const LabelMap> labels, const ProbeHand* hand);
  /// The vessels of this case, for vesselAt().
  void setVessels(VesselNames vessels);
  /// Sets the imaging whose frames tell how the tissue presses back, and which follows a device. After the call the
  /// previous one is not used any more.
  void setImaging(LiveImaging* imaging);

  /// Hears of every tick while something is in a hand; null for none. The one before hears of one more tick at most.
  void setAttempt(std::shared_ptr<LiveAttempt> attempt);

  /// Puts a device into a hand in place of the former one; no device: an empty hand. The limits of `setup` are the
  /// device's.
  void put(Hand hand, std::shared_ptr<HapticDevice> device, HandSetup setup);
  /// The hand of mouse and keys into this hand, at a pose of the tool (patientFromTool); it moves with moveByMouse().
  void putMouse(Hand hand, const Transform& patientFromTool);
  /// Sets the pose of the tool that mouse and keys aim at: their hand moves there smoothly, over a long distance at
  /// once; a simulated device's hand as far as the forces on it allow. No effect if the hand holds a real device.
  void moveByMouse(Hand hand, const Transform& patientFromTool);
  /// Device in the hand; null if the hand is empty.
  std::shared_ptr<HapticDevice> held(Hand hand) const;
  bool isMouse(Hand hand) const;
  /// Mouse and keys, or a simulated device, which they move.
  bool followsMouse(Hand hand) const;
  HandSetup setupOf(Hand hand) const;

  /// Holds the needle in its place in the patient, and its hand with it; after release, the needle continues from
  /// there with the hand's pose at that time. A needle that is taken up meanwhile is held, too.
  void holdNeedle(bool held);

  /// A pedal, or none. Its buttons that went down since the last takePresses(), one bit each.
  void setPedal(std::shared_ptr<HapticDevice> pedal);
  std::uint32_t takePresses();

  /// Pushes the device in a hand with this force, device frame, for a second, to be felt; held within 1 N and the
  /// hand's own limit. The tool does not move meanwhile. Nothing for an empty hand.
  void testForce(Hand hand, Vec3 force_N);

  /// Last tick of the servo; its time is 0 while both hands are empty.
  ServoSnapshot snapshot() const;
  std::vector<NeedleEvent> takeEvents();
  /// Name of the vessel of this label at a point of the patient, as vesselName() names that of an event there.
  std::string vesselAt(Label label, Vec3 patient_mm) const;
  RealTimeRights rights() const;
  TickTiming timing() const;
  /// The needle's tissue is there: before, the needle feels nothing.
  bool tissueReady() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace insonate
