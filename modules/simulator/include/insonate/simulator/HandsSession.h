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

/// Moves probe and needle over a patient by haptic devices, or by mouse and keys. A "hand" is one of these two tools;
/// it is empty while no device is assigned to it. The session runs the force loop (ServoThread). While a hand holds a
/// device, a thread passes the force loop 60 times a second the tissue in front of the probe's face and around the
/// needle's tip, and moves the live image with the probe. While both hands are empty and there is no pedal, no work is
/// done.
///
/// Every member may be called from any thread. put() and the destructor may wait up to a tenth of a second; all others
/// return within a fraction of a millisecond.
class HandsSession {
 public:
  /// Uses the devices of `bus` and the needle table `measured`. The search for devices begins at the first call of
  /// devices().
  explicit HandsSession(std::shared_ptr<haptics::HidBus> bus);
  /// Sends each device a last zero force and releases it.
  ~HandsSession();
  HandsSession(const HandsSession&) = delete;
  HandsSession& operator=(const HandsSession&) = delete;

  DeviceHub& devices();

  /// Sets the patient's labels, and a ProbeHand on the patient's skin; null: no patient. The tissue grid that the
  /// needle feels is computed in the background around the probe, and again if probe and needle have moved away from it
  /// while the needle is outside the body.
  void setCase(std::shared_ptr<const LabelMap> labels, const ProbeHand* hand);
  /// Sets the vessels of this case, for vesselAt().
  void setVessels(VesselNames vessels);
  /// Sets the live imaging that a device for the probe moves, and whose frames give the tissue's resistance to the
  /// probe; null: none. After the call, the previous object is no longer used.
  void setImaging(LiveImaging* imaging);

  /// Sets the attempt that records every tick of the force loop while a hand holds a device; null: none. The previous
  /// attempt receives one more tick at most.
  void setAttempt(std::shared_ptr<LiveAttempt> attempt);

  /// Assigns a device to a tool (`hand`: probe or needle) in place of its former device; null: none. HandSetup::limits
  /// is replaced by the device's limits.
  void put(Hand hand, std::shared_ptr<HapticDevice> device, HandSetup setup);
  /// Lets mouse and keys move a tool (`hand`: probe or needle), starting from the pose `patientFromTool`; see
  /// moveByMouse().
  void putMouse(Hand hand, const Transform& patientFromTool);
  /// Sets the pose of a tool that mouse and keys request. The tool moves there smoothly, or jumps if the distance is
  /// long; with a simulated device it moves there as far as the forces allow. No effect if a real device moves the
  /// tool.
  void moveByMouse(Hand hand, const Transform& patientFromTool);
  /// Returns the device that moves a tool (`hand`: probe or needle); null: none.
  std::shared_ptr<HapticDevice> held(Hand hand) const;
  bool isMouse(Hand hand) const;
  /// Tells whether mouse and keys move a tool: its device is that of putMouse(), or a simulated device.
  bool followsMouse(Hand hand) const;
  HandSetup setupOf(Hand hand) const;

  /// Fixes the needle in place in the patient (true), or releases it (false). After release, the needle moves on from
  /// its place as its device moves. A needle that is taken up in the meantime is fixed, too.
  void holdNeedle(bool held);

  /// Sets the device that serves as a pedal; null: none. takePresses() returns the buttons of the pedal that were
  /// pressed since its last call, one bit per button.
  void setPedal(std::shared_ptr<HapticDevice> pedal);
  std::uint32_t takePresses();

  /// Lets the device of a tool exert this force (device frame) for a second, as a test that the user feels. The force
  /// is limited to 1 N and to HandSetup::mostForce_N. The tool does not move meanwhile. No effect without a device.
  void testForce(Hand hand, Vec3 force_N);

  /// Returns inputs and outputs of the last tick of the force loop; time_ns is 0 while no device is assigned.
  ServoSnapshot snapshot() const;
  std::vector<NeedleEvent> takeEvents();
  /// Returns the name of the vessel with this label at a point; the same name that vesselName() gives to an event
  /// there.
  std::string vesselAt(Label label, Vec3 patient_mm) const;
  RealTimeRights rights() const;
  TickTiming timing() const;
  /// Tells whether the tissue grid for the needle is computed; until then no force acts on the needle.
  bool tissueReady() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace insonate
