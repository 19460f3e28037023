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

/// Indices of the two tools that haptic devices move: the probe and the needle.
enum Hand : int { kProbeHand = 0, kNeedleHand = 1 };

/// Transforms from a haptic device to the tool that it moves, and limits of its force. patientFromTool =
/// patientFromDevice * shift by apart_mm * deviceFromStylus * stylusFromTool. The tool frame of the probe is the probe
/// frame; that of the needle has its origin at the tip and z along the needle, in the direction of insertion.
struct HandSetup {
  Transform patientFromDevice;  ///< rigid pose of the device's workspace in patient space
  Vec3 apart_mm;                ///< offset of the tool from the stylus, device frame; lets two devices stand apart
  Transform stylusFromTool;     ///< rigid pose of the tool in the stylus's frame
  DeviceLimits limits;          ///< limits of the device's force and stiffness
  double gain = 1;              ///< fraction of the computed force that is sent to the device, 0 to 1
  double mostForce_N = 1e9;     ///< maximum force set by the user
};

/// Shapes of probe and needle for their mutual contact: capsules, as in figure 14 of the thesis (see
/// modules/haptics/README.md).
struct ToolShapes {
  /// half length and radius of the capsule parallel to the probe's face, just behind the face
  double faceHalfWidth_mm = 19, probeRadius_mm = 6;
  /// length of the capsule that stands for the probe's handle, along the probe's axis behind the face
  double handle_mm = 90;
  double needleLength_mm = 70, needleRadius_mm = 0.635;
};

struct ServoSetup {
  std::array<HandSetup, 2> hands;
  NeedleTable needle;
  ToolShapes shapes;
  double skinFriction = 0.1;  ///< Coulomb friction coefficient of the probe on wet skin
  /// true: the needle stays in place in the tissue while the user's hand moves; a spring pulls the device back to where
  /// it was. Probe and needle then exert no force on each other. When set to false, the needle follows its device
  /// again.
  bool needleHeld = false;
};

/// Input of one tick of the force loop: time and states of both devices.
struct ServoInput {
  std::int64_t now_ns = 0;  ///< time of the tick, CLOCK_MONOTONIC; increases with each tick
  std::array<DeviceState, 2> hands;
  std::array<bool, 2> present{};  ///< per tool; false: no device is assigned, or its connection is lost
};

/// Output of one tick of the force loop for one tool (probe or needle).
struct HandOutput {
  Force force;                 ///< force to send to the device, in the device's frame, within the device's limits
  Transform patientFromTool;   ///< pose of the tool as the device holds it
  Transform patientFromShown;  ///< pose at which the program draws the tool; unlike patientFromTool never inside bone
  Vec3 wanted_N;               ///< force of tissue and of the other tool before any limit, patient space
  /// energy that the user's hand has put into the virtual tissue and not got back; decays with time
  double energy_J = 0;
  bool limited = false;  ///< true: the force was reduced, by a limit, missing inputs or passivity control (energy_J)
};

/// Output of one tick of the force loop.
struct ServoOutput {
  std::array<HandOutput, 2> hands;
  NeedleState needle;
  double skinForce_N = 0;    ///< force of the probe on the skin, along the probe's axis
  double skinIndent_mm = 0;  ///< depth of the deepest point of the probe's face below the undeformed skin
  std::array<NeedleEvent, 16> events;
  int eventCount = 0;
};

/// Force loop: computes the forces on probe and needle once per tick (1 ms). tick() is for one thread; setup() and
/// show() (sets the tissue) may be called from one other thread each, at any time, and take effect at the next tick.
///
/// Forces fall to zero within 100 ms if device states or tissue models (LocalModel) stop arriving, and at once if a
/// device is not present. A hand never gets more energy back than it put in (see modules/haptics/README.md).
class HapticServo {
 public:
  HapticServo();
  ~HapticServo();
  HapticServo(HapticServo&&) noexcept;
  HapticServo& operator=(HapticServo&&) noexcept;

  void setup(const ServoSetup& setup);
  void show(LocalModel model);

  /// Computes one tick: device states in, forces and tool poses out. Neither waits, allocates nor throws.
  ServoOutput tick(const ServoInput& input) noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace insonate
