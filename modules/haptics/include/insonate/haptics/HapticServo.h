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

/// Transform chain from one device to a tool: patientFromTool = patientFromDevice * shift by apart_mm *
/// deviceFromStylus * stylusFromTool. The probe's tool frame is the probe's; the needle's has its origin at the tip and
/// z along the needle, in the direction of insertion.
struct HandSetup {
  Transform patientFromDevice;  ///< rigid
  Vec3 apart_mm;             ///< device frame: offset of the tool from the device, so that two devices do not collide
  Transform stylusFromTool;  ///< rigid
  DeviceLimits limits;       ///< limits of forces and stiffness
  double gain = 1;           ///< 0 to 1: share of the force that is sent to the hand
  double mostForce_N = 1e9;  ///< the user's own limit
};

/// Shapes of the tools for their contact: capsules, as in figure 14 of the thesis.
struct ToolShapes {
  double faceHalfWidth_mm = 19, probeRadius_mm = 6;  ///< capsule along the face, just behind it
  double handle_mm = 90;                             ///< length of the capsule along the probe's axis, behind the face
  double needleLength_mm = 70, needleRadius_mm = 0.635;
};

struct ServoSetup {
  std::array<HandSetup, 2> hands;
  NeedleTable needle;
  ToolShapes shapes;
  double skinFriction = 0.1;  ///< friction of the probe on wet skin: force along the skin over force into the skin
  /// Holds the needle in its place in the tissue, independent of the hand; a spring pulls the hand to the place where
  /// it was. Probe and needle then exert no force on each other. After release, the hand's setup determines the
  /// needle's pose as usual.
  bool needleHeld = false;
};

struct ServoInput {
  std::int64_t now_ns = 0;  ///< CLOCK_MONOTONIC; increases with each tick
  std::array<DeviceState, 2> hands;
  std::array<bool, 2> present{};  ///< false: no device, or the device is lost
};

struct HandOutput {
  Force force;                 ///< for the device, in its frame, within its limits
  Transform patientFromTool;   ///< pose at which the tool is held
  Transform patientFromShown;  ///< pose at which images show the tool: never inside bone
  Vec3 wanted_N;               ///< force of tissue and the other tool before any limit, patient space
  double energy_J = 0;         ///< energy that the hand has put in and not got back; old energy is forgotten
  bool limited = false;        ///< the force was reduced by a limit, by missing inputs or by the energy account
};

struct ServoOutput {
  std::array<HandOutput, 2> hands;
  NeedleState needle;
  double skinForce_N = 0;    ///< force of the probe on the skin, along the probe's axis
  double skinIndent_mm = 0;  ///< depth of the face's deepest point below the skin at rest
  std::array<NeedleEvent, 16> events;
  int eventCount = 0;
};

/// Computes the forces of both hands every millisecond. tick() is for one thread; setup() and show() may be called from
/// one other thread each, at any time, and take effect at the next tick.
///
/// Forces fall to zero within 100 ms if a device's states or the local model stop arriving, and at once if a device is
/// not present. A hand never gets more energy back than it gave (see modules/haptics/README.md).
class HapticServo {
 public:
  HapticServo();
  ~HapticServo();
  HapticServo(HapticServo&&) noexcept;
  HapticServo& operator=(HapticServo&&) noexcept;

  void setup(const ServoSetup& setup);
  void show(LocalModel model);

  /// Computes one tick. Neither waits, allocates nor throws.
  ServoOutput tick(const ServoInput& input) noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace insonate
