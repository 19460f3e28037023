#pragma once

#include <insonate/haptics/DeviceHub.h>
#include <insonate/haptics/MouseDevice.h>
#include <insonate/haptics/ServoThread.h>
#include <insonate/image/Volume.h>
#include <insonate/simulator/LiveImaging.h>
#include <insonate/simulator/ProbePlacement.h>
#include <insonate/simulator/VesselLocator.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace insonate {

class LiveAttempt;

/// Moves probe and needle over a patient by haptic devices, or by mouse and keys. The enum HapticTool names the two
/// tools; parameters called `hand` select one of them. The session runs the force loop (ServoThread). While a device is
/// assigned, a thread of the session passes the tissue in front of the probe's face and around the needle's tip to the
/// force loop 60 times a second, and passes the pose of the probe to the live imaging. While no device is assigned to
/// either tool and there is no pedal, the session does no work.
///
/// Every member may be called from any thread. assignDevice() and the destructor may wait up to a tenth of a second;
/// all others return within a fraction of a millisecond.
class HapticSession {
 public:
  /// Uses the devices of `bus` and the needle table `measured`. The search for devices begins at the first call of
  /// devices().
  explicit HapticSession(std::shared_ptr<haptics::HidBus> bus);
  /// Sends a zero force to each device and releases the devices.
  ~HapticSession();
  HapticSession(const HapticSession&) = delete;
  HapticSession& operator=(const HapticSession&) = delete;

  /// Returns all haptic devices and pedals. The first call starts the search for devices.
  DeviceHub& devices();

  /// Sets the patient: `labels`, and the placement of the probe on the patient's skin (`hand`). No patient if `labels`
  /// is null. A background thread computes the tissue grid for the forces on the needle, in a region around the probe.
  /// While the needle is outside the body, the grid is computed again around the probe as soon as both probe and needle
  /// are outside the region.
  void setCase(std::shared_ptr<const LabelMap> labels, const ProbePlacement* hand);
  /// Sets the vessels of this case, for vesselAt().
  void setVessels(VesselLocator vessels);
  /// Sets the live imaging whose probe the assigned device moves, and from whose frames the resistance of the tissue to
  /// the probe is taken; null: none. When the function returns, the previous object is no longer used.
  void setImaging(LiveImaging* imaging);

  /// Sets the attempt that records every tick of the force loop while a device is assigned; null: none. The previous
  /// attempt receives at most one more tick.
  void setAttempt(std::shared_ptr<LiveAttempt> attempt);

  /// Assigns a device to a tool (`hand`: probe or needle) in place of its previous device; null: no device.
  /// `setup.limits` is ignored; the device's own limits are used.
  void assignDevice(HapticTool hand, std::shared_ptr<HapticDevice> device, ToolSetup setup);
  /// Assigns mouse and keys to a tool (`hand`: probe or needle), whose pose is then `patientFromTool`. moveByMouse()
  /// moves the tool.
  void assignMouse(HapticTool hand, const Transform& patientFromTool);
  /// Sets the pose of a tool that mouse and keys request. The tool moves there smoothly, or jumps if the distance is
  /// long; with a simulated device it moves there as far as the forces allow. Has no effect if a real device moves the
  /// tool.
  void moveByMouse(HapticTool hand, const Transform& patientFromTool);
  /// Returns the device that moves a tool (`hand`: probe or needle); null: none.
  std::shared_ptr<HapticDevice> assignedDevice(HapticTool hand) const;
  /// Tells whether mouse and keys are assigned to a tool (assignMouse()).
  bool isMouseAssigned(HapticTool hand) const;
  /// Tells whether mouse and keys move a tool: its device is that of assignMouse(), or a simulated device.
  bool followsMouse(HapticTool hand) const;
  /// Returns the transforms and force limits with which assignDevice() assigned a device to the tool.
  ToolSetup setupOf(HapticTool hand) const;

  /// Fixes the needle in its place in the patient (true), or releases it (false). After the release, the needle moves
  /// on from its place as its device moves. A needle to which a device is assigned in the meantime is also fixed.
  void setNeedleFixed(bool held);
  /// Sets what the hand at the needle's device does while the needle is fixed, and the instrument that it grips.
  void setFreeHand(FreeHand hand, const WireGrip& wire = {});

  /// Sets the device that is used as a pedal; null: none.
  void setPedal(std::shared_ptr<HapticDevice> pedal);
  /// Returns the buttons of the pedal that were pressed since the last call, one bit per button.
  std::uint32_t takePedalPresses();

  /// Makes the device of a tool exert this force (device frame) for a second, so that the user can check the device.
  /// The force is limited to 1 N and to ToolSetup::userMaxForce_N. The tool does not move during this second. Has no
  /// effect without a device.
  void testForce(HapticTool hand, Vec3 force_N);

  /// Returns inputs and outputs of the last tick of the force loop; time_ns is 0 while no device is assigned.
  ServoSnapshot snapshot() const;
  /// Returns the needle's events (punctures, contacts with bone) since the last call, oldest first.
  std::vector<NeedleEvent> takeEvents();
  /// Returns the name of the vessel with this label at a point, as vesselName() does for an event at this point.
  std::string vesselAt(Label label, Vec3 patient_mm) const;
  /// Returns the real-time privileges of the force loop's thread.
  RealTimeRights realTimeRights() const;
  /// Returns the timing statistics of the force loop.
  TickTiming tickTiming() const;
  /// Tells whether the tissue grid for the needle has been computed. Until then no force acts on the needle.
  bool isTissueGridReady() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace insonate
