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

/// The two tools that haptic devices move, as indices of arrays such as ServoInput::tools: the probe and the needle.
enum HapticTool : int { kProbeTool = 0, kNeedleTool = 1 };

/// Transforms from a haptic device to the tool that it moves, and limits of its force. patientFromTool =
/// patientFromDevice * (translation by apart_mm) * deviceFromStylus * stylusFromTool. The tool frame of the probe is
/// the probe frame. The tool frame of the needle has its origin at the tip and z along the needle, in the direction of
/// insertion.
struct ToolSetup {
  Transform patientFromDevice;  ///< rigid pose of the device's workspace in patient space
  /// offset of the tool from the stylus, device frame. The offset lets two devices stand apart on the desk while probe
  /// and needle meet in the patient.
  Vec3 apart_mm;
  Transform stylusFromTool;     ///< rigid pose of the tool in the stylus frame
  DeviceLimits limits;          ///< limits of the device's force and stiffness
  double gain = 1;              ///< fraction of the computed force that is sent to the device, 0 to 1
  double userMaxForce_N = 1e9;  ///< maximum force, N, as set by the user
};

/// Shapes of probe and needle for their mutual contact: capsules, as in figure 14 of the thesis (see
/// modules/haptics/README.md).
struct ToolShapes {
  /// half length and radius of the capsule parallel to the probe's face, just behind the face
  double faceHalfWidth_mm = 19, probeRadius_mm = 6;
  /// length of the capsule for the probe's handle, along the probe's axis behind the face
  double handle_mm = 90;
  double needleLength_mm = 70, needleRadius_mm = 0.635;
};

/// The hand that moves the needle's device, while the needle stays in its place.
enum class FreeHand {
  AtNeedle,  ///< a spring pulls the device back to its place
  Free,      ///< the hand moves without force, to grip an instrument at another place
  AtWire     ///< the hand grips an instrument that slides along the needle's axis, as a wire does (see WireGrip)
};

/// Instrument that the hand grips: the hand is pulled to the place to which the instrument has gone, and pushed back by
/// the instrument's resistance.
struct WireGrip {
  double gone_mm = 0;       ///< distance that the instrument has gone into the body since the hand gripped it
  double resistance_N = 0;  ///< force of the instrument on the hand, against the insertion
};

struct ServoSetup {
  std::array<ToolSetup, 2> tools;
  NeedleTable needle;
  ToolShapes shapes;
  double skinFriction = 0.1;  ///< Coulomb friction coefficient of the probe on wet skin
  /// true: the needle stays in its place in the tissue while the user's hand moves, and a spring pulls the device back
  /// to its place. Probe and needle then exert no force on each other. false: the needle follows its device.
  bool needleFixed = false;
  FreeHand freeHand = FreeHand::AtNeedle;  ///< used while `needleFixed` is true
  WireGrip wire;                           ///< used while `freeHand` is AtWire
};

/// Input of one tick of the force loop: time and states of both devices.
struct ServoInput {
  std::int64_t now_ns = 0;  ///< time of the tick, CLOCK_MONOTONIC; increases with each tick
  std::array<DeviceState, 2> tools;
  /// for each tool; false: no device is assigned to the tool, or its connection is lost
  std::array<bool, 2> present{};
};

/// Output of one tick of the force loop for one tool (probe or needle).
struct ToolOutput {
  Force force;                 ///< force to send to the device, in the device frame, within the device's limits
  Transform patientFromTool;   ///< pose of the tool as the device holds it
  Transform patientFromShown;  ///< pose at which the program draws the tool; unlike patientFromTool never inside bone
  Vec3 wanted_N;               ///< force of tissue and of the other tool before any limit, patient space
  /// energy that the user's hand has put into the virtual tissue and has not yet received back; decays with time
  double energy_J = 0;
  bool limited = false;  ///< true: the force was reduced, by a limit, missing inputs or passivity control (energy_J)
};

/// Output of one tick of the force loop.
struct ServoOutput {
  std::array<ToolOutput, 2> tools;
  NeedleState needle;
  double skinForce_N = 0;    ///< force of the probe on the skin, along the probe's axis
  double skinIndent_mm = 0;  ///< depth of the deepest point of the probe's face below the undeformed skin
  /// FreeHand::AtWire: distance that the hand has moved along the needle, into the body, since it gripped the wire
  double wireHand_mm = 0;
  std::array<NeedleEvent, 16> events;
  int eventCount = 0;
};

/// Force loop: computes the forces on probe and needle once per tick (1 ms). configure() sets devices and tools,
/// setLocalModel() sets the tissue. tick() is for one thread. configure() and setLocalModel() may each be called from
/// one other thread, at any time, and take effect at the next tick.
///
/// Forces fall to zero within 100 ms if device states or tissue models (LocalModel) stop arriving, and at once if a
/// device is not present. The user's hand never receives more energy than it has put in (passivity control; see
/// modules/haptics/README.md).
class HapticServo {
 public:
  HapticServo();
  ~HapticServo();
  HapticServo(HapticServo&&) noexcept;
  HapticServo& operator=(HapticServo&&) noexcept;

  /// Sets devices, tools and tissue properties from the next tick on.
  void configure(const ServoSetup& setup);
  /// Sets the tissue near probe and needle from the next tick on.
  void setLocalModel(LocalModel model);

  /// Computes one tick: device states in, forces and tool poses out. Neither waits, allocates nor throws.
  ServoOutput tick(const ServoInput& input) noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace insonate
