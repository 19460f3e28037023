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
/// needle's tip, and moves the live image with the held probe. While both hands are empty and there is no pedal, no
/// work is done.
///
/// Every member may be called from any thread; none waits longer than a fraction of a millisecond but put() and the
/// destructor. These may wait for a tick and for a step of the tissue's preparation, up to a tenth of a second.
class HandsSession {
 public:
  /// Uses the devices of `bus` and the built-in needle `measured`. The search for devices begins at the first call of
  /// devices().
  explicit HandsSession(std::shared_ptr<haptics::HidBus> bus);
  /// Releases all devices after a last zero force.
  ~HandsSession();
  HandsSession(const HandsSession&) = delete;
  HandsSession& operator=(const HandsSession&) = delete;

  DeviceHub& devices();

  /// Sets the patient's tissues, and a hand on that patient's skin; null: no patient. The needle's tissue is prepared
  /// in the background around the probe, and again around the hands if they have moved away with the needle outside the
  /// body.
  void setCase(std::shared_ptr<const LabelMap> labels, const ProbeHand* hand);
  /// Sets the vessels of this case, for vesselAt().
  void setVessels(VesselNames vessels);
  /// Sets the imaging whose frames tell how strongly the tissue resists the probe. A device in the probe hand moves
  /// this imaging. After the call, the previous imaging is no longer used.
  void setImaging(LiveImaging* imaging);

  /// Sets the attempt that receives every tick while a hand holds something; null for no attempt. The previous attempt
  /// receives one more tick at most.
  void setAttempt(std::shared_ptr<LiveAttempt> attempt);

  /// Puts a device into a hand in place of the former device; null leaves the hand empty. The limits in `setup` are
  /// replaced by the device's.
  void put(Hand hand, std::shared_ptr<HapticDevice> device, HandSetup setup);
  /// Lets mouse and keys move this hand, from this pose of the tool (patientFromTool) on; see moveByMouse().
  void putMouse(Hand hand, const Transform& patientFromTool);
  /// Sets the pose of the tool that mouse and keys request. A hand that follows mouse and keys moves there smoothly, or
  /// jumps if the distance is long; the hand of a simulated device moves there as far as the forces on it allow. No
  /// effect if the hand holds a real device.
  void moveByMouse(Hand hand, const Transform& patientFromTool);
  /// Device in the hand; null if the hand is empty.
  std::shared_ptr<HapticDevice> held(Hand hand) const;
  bool isMouse(Hand hand) const;
  /// Tells whether mouse and keys move this hand: it holds the device of putMouse(), or a simulated device.
  bool followsMouse(Hand hand) const;
  HandSetup setupOf(Hand hand) const;

  /// Holds the needle, and its hand, in place in the patient. After release, the needle continues from there with the
  /// hand's pose at that time. A needle that is taken up in the meantime is held, too.
  void holdNeedle(bool held);

  /// Sets the device that serves as a pedal; null: no pedal. takePresses() returns the buttons of the pedal that went
  /// down since its last call, one bit each.
  void setPedal(std::shared_ptr<HapticDevice> pedal);
  std::uint32_t takePresses();

  /// Pushes the device in a hand with this force (device frame) for a second, so that the user feels it. The force is
  /// limited to 1 N and to the hand's own limit. The tool does not move meanwhile. No effect on an empty hand.
  void testForce(Hand hand, Vec3 force_N);

  /// Returns the last tick of the servo; its time is 0 while both hands are empty.
  ServoSnapshot snapshot() const;
  std::vector<NeedleEvent> takeEvents();
  /// Name of the vessel at a point of the patient that has this label; the same name that vesselName() gives to an
  /// event there.
  std::string vesselAt(Label label, Vec3 patient_mm) const;
  RealTimeRights rights() const;
  TickTiming timing() const;
  /// Tells whether the needle's tissue is ready; until then the needle feels no force.
  bool tissueReady() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace insonate
