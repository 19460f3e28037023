#pragma once

#include <insonate/haptics/DeviceLimits.h>
#include <insonate/haptics/DeviceState.h>
#include <insonate/haptics/Force.h>
#include <insonate/haptics/LocalModel.h>
#include <insonate/haptics/NeedleState.h>
#include <insonate/tissue/NeedleTable.h>

#include <array>
#include <cstdint>
#include <memory>

namespace insonate {

/// The two hands, as indices.
enum Hand : int { kProbeHand = 0, kNeedleHand = 1 };

/// Mapping of one device to a tool: patientFromTool = patientFromDevice * shift by apart_mm * deviceFromStylus *
/// stylusFromTool. The probe's tool frame is the probe's; the needle's has its origin at the tip and z along the
/// needle, in the direction of insertion.
struct HandSetup {
  Transform patientFromDevice;  ///< rigid
  Vec3 apart_mm;  ///< device frame: from where the device is to where its tool is, so that two do not collide
  Transform stylusFromTool;  ///< rigid
  DeviceLimits limits;       ///< forces and stiffness stay below these
  double gain = 1;           ///< 0 to 1: share of the force that the hand gets
  double mostForce_N = 1e9;  ///< the user's own limit
};

/// Shape of the tools where they touch each other: capsules, as in the thesis's figure 14.
struct ToolShapes {
  double faceHalfWidth_mm = 19, probeRadius_mm = 6;  ///< a bar along the face, just behind it
  double handle_mm = 90;                             ///< and one along the probe's axis, behind it
  double needleLength_mm = 70, needleRadius_mm = 0.635;
};

struct ServoSetup {
  std::array<HandSetup, 2> hands;
  NeedleTable needle;
  ToolShapes shapes;
  double skinFriction = 0.1;  ///< of the probe on wet skin: force along over force into the skin
  /// Holds the needle in its place in the tissue, independent of its hand, and its hand where it was; the tools do not
  /// meet. After release, the hand's setup determines the needle's pose as usual.
  bool needleHeld = false;
};

struct ServoInput {
  std::int64_t now_ns = 0;  ///< CLOCK_MONOTONIC; each tick later than the last
  std::array<DeviceState, 2> hands;
  std::array<bool, 2> present{};  ///< false: no device, or it is lost
};

struct HandOutput {
  Force force;                 ///< for the device, in its frame; within its limits
  Transform patientFromTool;   ///< where the tool is held
  Transform patientFromShown;  ///< where images show it: no needle in bone
  Vec3 wanted_N;               ///< what tissue and the other tool would give, patient space, before any limit
  double energy_J = 0;         ///< that the hand has given and not got back, as far as it is remembered
  bool limited = false;        ///< a limit, silence or the energy account took something off
};

struct ServoOutput {
  std::array<HandOutput, 2> hands;
  NeedleState needle;
  double skinForce_N = 0;    ///< of the probe on the skin, along its axis
  double skinIndent_mm = 0;  ///< deepest point of the face below the skin at rest
  std::array<NeedleEvent, 16> events;
  int eventCount = 0;
};

/// Computes the forces of both hands every millisecond. tick() is for one thread; setup() and show() may be called
/// from one other thread each, at any time, and take effect at the next tick.
///
/// Forces fall to zero within 100 ms when a device's states or the local model stop arriving, and at once when a
/// device is not present. A hand never gets more energy back than it gave (see modules/haptics/README.md).
class HapticServo {
 public:
  HapticServo();
  ~HapticServo();
  HapticServo(HapticServo&&) noexcept;
  HapticServo& operator=(HapticServo&&) noexcept;

  void setup(const ServoSetup& setup);
  void show(LocalModel model);

  /// Neither waits, allocates nor throws.
  ServoOutput tick(const ServoInput& input) noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace insonate
