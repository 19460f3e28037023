#include "needle/NeedleMechanics.h"
#include "servo/EnergyTank.h"
#include "servo/ForceGuard.h"
#include "servo/ProbeContact.h"
#include "servo/ToolContact.h"

#include <insonate/haptics/HapticServo.h>
#include <insonate/haptics/LatestValue.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace insonate {
namespace {

using namespace haptics;

/// Stiffness of devices whose manufacturer states none, and of hands without a device.
constexpr double kUnknownStiffness_Npmm = 1;
/// Maximum deflection of a spring: it cannot store more than force times this; energy of the account beyond it was lost
/// in friction.
constexpr double kMaxSpring_mm = 15;

double steepest_Npmm(const ToolSetup& hand) {
  return hand.limits.maxStiffness_Npmm > 0 ? hand.limits.maxStiffness_Npmm : kUnknownStiffness_Npmm;
}

/// Share of a device's stiffness for the spring that holds the hand of a held needle.
constexpr double kHoldShare = 0.5;

/// Below the mass of any device at its stylus.
constexpr double kMinMass_kg = 0.03;

/// Share of a device's dissipation that its own account may use; the remainder is for the account of the tools'
/// contact.
constexpr double kOwnShare = 0.75;

/// Small rotation between two attitudes, as a vector.
Vec3 turnedBy(const Mat3& from, const Mat3& to) {
  Vec3 sum;
  for (int i = 0; i < 3; ++i) sum = sum + cross(from.column[i], to.column[i]);
  return sum * 0.5;
}

struct HandState {
  ToolSetup setup;
  ForceGuard guard;
  EnergyTank tank;
  Transform patientFromStylus, patientFromTool;
  Mat3 attitude;
  Vec3 device_mm;              // of the stylus, device frame
  Vec3 fromOther_N;            // part of the last force that the other tool caused
  double givenToOther_mJ = 0;  // energy of this part since then, N mm
  bool present = false;
  std::int64_t seen_ns = 0;

  void configure(const ToolSetup& s) {
    // A changed mapping of the tool is not a motion of the hand.
    if (!(s.patientFromDevice == setup.patientFromDevice) || !(s.apart_mm == setup.apart_mm)) {
      tank.reset();
      fromOther_N = {};
    }
    setup = s;
    GuardLimits limits;
    limits.force_N = std::min(s.limits.maxForce_N, std::max(0.0, s.userMaxForce_N));
    limits.torque_Nmm = s.limits.forceAxes >= 6 ? s.limits.maxTorque_Nmm : 0;
    guard.setLimits(limits);
    const DeviceLimits& device = s.limits;
    tank.setLimits({.max_J = limits.force_N * kMaxSpring_mm * 1e-3,
                    .friction_N = kOwnShare * device.friction_N,
                    .damping_Nspmm = kOwnShare * device.damping_Nspm * 1e-3,
                    .resolution_mm = device.resolution_mm,
                    .mass_kg = device.mass_kg > 0 ? device.mass_kg : kMinMass_kg});
  }
};

struct Wanted {
  Force tissue, tool;  // patient space, about the tool's origin
};

/// The same force about another point.
Force about(const Force& force, Vec3 from, Vec3 to) {
  return {force.force_N, force.torque_Nmm + cross(from - to, force.force_N)};
}

}  // namespace

struct HapticServo::State {
  struct Numbered {
    ServoSetup setup;
    int number = 0;
  };
  LatestValue<Numbered> setups;
  int written = 0, taken = -1;
  LatestValue<LocalModel> models;

  std::array<HandState, 2> hands;
  ToolShapes shapes;
  double skinFriction = 0;
  ProbeContact skin;
  NeedleMechanics needle;
  ToolContact tools;
  EnergyTank between;  // of the tools' contact, by their relative motion
  struct Held {
    Transform patientFromTool;
    Vec3 device_mm;  // of the stylus, when the needle was held
  };
  bool holds = false;  // the setup's request
  FreeHand freeHand = FreeHand::AtNeedle;
  WireGrip wire;
  std::optional<double> grippedAt_mm;  // place of the hand along the needle when it gripped the wire
  std::optional<Held> held;            // the held needle, from the end of the first tick on
  std::int64_t last_ns = 0;

  void takeSetup();
  void place(HandState& hand, const DeviceState& device, bool present);
  void keepNeedle();
  void touch(const LocalModel& model, double step_s, std::array<Wanted, 2>& wanted, ServoOutput& out);
  void touchNeedle(const LocalModel& model, double step_s, Wanted& wanted, ServoOutput& out);
  Vec3 forceOnFreeHand_N(ServoOutput& out);
  void touchTools(double step_s, std::array<Wanted, 2>& wanted);
  void send(HandState& hand, const Wanted& wanted, std::int64_t silent_ns, std::int64_t step_ns, ToolOutput& out);
};

void HapticServo::State::takeSetup() {
  const Numbered& latest = setups.read();
  if (latest.number == taken) return;
  taken = latest.number;
  for (int i = 0; i < 2; ++i) hands[i].configure(latest.setup.tools[i]);
  shapes = latest.setup.shapes;
  skinFriction = latest.setup.skinFriction;
  holds = latest.setup.needleFixed, wire = latest.setup.wire;
  const bool isBack =
      std::exchange(freeHand, latest.setup.freeHand) != FreeHand::AtNeedle && freeHand == FreeHand::AtNeedle;
  // The spring holds the hand where it takes the needle again, and does not pull it there from afar.
  if (isBack && held) held->device_mm = hands[kNeedleTool].device_mm;
  const DeviceLimits &a = latest.setup.tools[0].limits, &b = latest.setup.tools[1].limits;
  between.setLimits({.max_J = 0.05,
                     .friction_N = (1 - kOwnShare) * std::min(a.friction_N, b.friction_N),
                     .resolution_mm = a.resolution_mm + b.resolution_mm,
                     .mass_kg = std::max(kMinMass_kg, 0.5 * std::min(a.mass_kg, b.mass_kg))});
  needle.configure(latest.setup.needle, steepest_Npmm(hands[kNeedleTool].setup));
}

void HapticServo::State::place(HandState& hand, const DeviceState& device, bool present) {
  hand.present = present && isFinite(device.deviceFromStylus.offset);
  if (!hand.present) {
    hand.guard.reset();
    hand.tank.reset();
    hand.fromOther_N = {};
    hand.givenToOther_mJ = 0;
    return;
  }
  hand.seen_ns = device.time_ns;
  hand.device_mm = device.deviceFromStylus.offset;
  Transform shifted = hand.setup.patientFromDevice;
  shifted.offset = shifted * hand.setup.apart_mm;
  hand.attitude = hand.patientFromStylus.linear;
  const Vec3 before_mm = hand.patientFromStylus.offset;
  hand.patientFromStylus = shifted * device.deviceFromStylus;
  hand.givenToOther_mJ = -dot(hand.fromOther_N, hand.patientFromStylus.offset - before_mm);
  hand.patientFromTool = hand.patientFromStylus * hand.setup.stylusFromTool;
}

/// A needle that is absent or released is no longer held.
void HapticServo::State::keepNeedle() {
  HandState& hand = hands[kNeedleTool];
  if (!holds || !hand.present)
    held.reset(), grippedAt_mm.reset();
  else if (held)
    hand.patientFromTool = held->patientFromTool;
}

void HapticServo::State::touch(const LocalModel& model, double step_s, std::array<Wanted, 2>& wanted,
                               ServoOutput& out) {
  HandState& probe = hands[kProbeTool];
  if (probe.present) {
    const SkinForce felt = skin.press(model, probe.patientFromTool, steepest_Npmm(probe.setup), skinFriction, step_s);
    wanted[kProbeTool].tissue = felt.force;
    out.skinForce_N = felt.axial_N;
    out.skinIndent_mm = felt.deepest_mm;
  } else {
    skin.reset();
  }
  touchNeedle(model, step_s, wanted[kNeedleTool], out);
  touchTools(step_s, wanted);
}

/// Force on the hand while the needle stays in its place.
Vec3 HapticServo::State::forceOnFreeHand_N(ServoOutput& out) {
  const HandState& hand = hands[kNeedleTool];
  const Vec3 away_mm = hand.setup.patientFromDevice.linear * (hand.device_mm - held->device_mm);
  const double stiffness_Npmm = kHoldShare * steepest_Npmm(hand.setup);
  if (freeHand != FreeHand::AtWire) grippedAt_mm.reset();
  if (freeHand == FreeHand::AtNeedle) return away_mm * -stiffness_Npmm;
  if (freeHand == FreeHand::Free) return {};
  const Vec3 axis = held->patientFromTool.linear.column[2];
  const double along_mm = dot(away_mm, axis);
  if (!grippedAt_mm) grippedAt_mm = along_mm;
  out.wireHand_mm = along_mm - *grippedAt_mm;
  return axis * (-stiffness_Npmm * (out.wireHand_mm - wire.gone_mm) - wire.resistance_N);
}

void HapticServo::State::touchNeedle(const LocalModel& model, double step_s, Wanted& wanted, ServoOutput& out) {
  const HandState& hand = hands[kNeedleTool];
  NeedleEvents events;
  if (held) {
    wanted.tissue = about({forceOnFreeHand_N(out), {}}, hand.patientFromStylus.offset, hand.patientFromTool.offset);
  } else if (hand.present && model.grid) {
    const NeedleForce felt = needle.move(*model.grid, model.restFromPatient, hand.patientFromTool.offset,
                                         hand.patientFromTool.linear.column[2], step_s, last_ns, events);
    wanted.tissue = {felt.force_N, felt.torque_Nmm};
  } else {
    needle.remove(last_ns, events);
  }
  out.events = events.list;
  out.eventCount = events.count;
  if (holds && hand.present && !held) held = Held{hand.patientFromTool, hand.device_mm};
  out.needle = needle.state();
}

void HapticServo::State::touchTools(double step_s, std::array<Wanted, 2>& wanted) {
  const HandState &probe = hands[kProbeTool], &needleHand = hands[kNeedleTool];
  if (!probe.present || !needleHand.present || held) {
    tools.reset();
    between.reset();
    return;
  }
  const double stiffness_Npmm = 0.5 * std::min(steepest_Npmm(probe.setup), steepest_Npmm(needleHand.setup));
  Force &onProbe = wanted[kProbeTool].tool, &onNeedle = wanted[kNeedleTool].tool;
  tools.push(probe.patientFromTool, needleHand.patientFromTool, shapes, stiffness_Npmm, onProbe, onNeedle);
  const Vec3 apart_mm = needleHand.patientFromStylus.offset - probe.patientFromStylus.offset;
  const double full_N = norm(onNeedle.force_N);
  const Force paid = between.pass({onNeedle.force_N, {}}, {},
                                  {apart_mm, {}, probe.givenToOther_mJ + needleHand.givenToOther_mJ}, step_s);
  // Both tools get the same force, so that neither is pushed by a force that the other does not feel.
  const double share = full_N > 0 ? std::min(1.0, norm(paid.force_N) / full_N) : 1;
  onNeedle = {onNeedle.force_N * share, onNeedle.torque_Nmm * share};
  onProbe = {onProbe.force_N * share, onProbe.torque_Nmm * share};
}

void HapticServo::State::send(HandState& hand, const Wanted& wanted, std::int64_t silent_ns, std::int64_t step_ns,
                              ToolOutput& out) {
  out.patientFromTool = out.patientFromShown = hand.patientFromTool;
  if (!hand.present) return;
  const double gain = std::clamp(hand.setup.gain, 0.0, 1.0);
  const Vec3 tool = hand.patientFromTool.offset, stylus = hand.patientFromStylus.offset;
  out.wanted_N = wanted.tissue.force_N + wanted.tool.force_N;
  Force sum = about({out.wanted_N, wanted.tissue.torque_Nmm + wanted.tool.torque_Nmm}, tool, stylus);
  sum = {sum.force_N * gain, sum.torque_Nmm * gain};
  const Force guarded = hand.guard.pass(sum, silent_ns, step_ns);
  const bool turns = hand.guard.limits().torque_Nmm > 0;
  const StylusPlace place{stylus, turns ? turnedBy(hand.attitude, hand.patientFromStylus.linear) : Vec3{}, {}};
  const double share = norm(sum.force_N) > 0 ? norm(guarded.force_N) / norm(sum.force_N) : 0;
  hand.fromOther_N = wanted.tool.force_N * (gain * std::min(share, 1.0));
  const Force sent = hand.tank.pass(guarded, hand.fromOther_N, place, static_cast<double>(step_ns) * 1e-9);
  out.energy_J = hand.tank.energy_J();
  out.limited = norm(sent.force_N - sum.force_N) > 1e-6;
  const Mat3 deviceFromPatient = transposed(hand.setup.patientFromDevice.linear);
  out.force = {deviceFromPatient * sent.force_N, deviceFromPatient * sent.torque_Nmm};
}

HapticServo::HapticServo() : state_(std::make_unique<State>()) {}
HapticServo::~HapticServo() = default;
HapticServo::HapticServo(HapticServo&&) noexcept = default;
HapticServo& HapticServo::operator=(HapticServo&&) noexcept = default;

void HapticServo::configure(const ServoSetup& setup) {
  state_->setups.write({setup, ++state_->written});
}

void HapticServo::setLocalModel(LocalModel model) {
  state_->models.write(std::move(model));
}

ServoOutput HapticServo::tick(const ServoInput& input) noexcept {
  State& s = *state_;
  s.takeSetup();
  const LocalModel& model = s.models.read();
  const std::int64_t step_ns = s.last_ns > 0 ? std::max<std::int64_t>(input.now_ns - s.last_ns, 0) : 1'000'000;
  s.last_ns = input.now_ns;
  for (int i = 0; i < 2; ++i) s.place(s.hands[i], input.tools[i], input.present[i]);
  s.keepNeedle();
  ServoOutput out;
  std::array<Wanted, 2> wanted;
  s.touch(model, static_cast<double>(step_ns) * 1e-9, wanted, out);
  for (int i = 0; i < 2; ++i) {
    const std::int64_t oldest_ns = std::min(model.time_ns, s.hands[i].seen_ns);
    s.send(s.hands[i], wanted[i], std::max<std::int64_t>(0, input.now_ns - oldest_ns), step_ns, out.tools[i]);
  }
  Transform& shown = out.tools[kNeedleTool].patientFromShown;
  shown.offset = shown * Vec3{0, 0, -s.needle.drawnBack_mm()};
  return out;
}

}  // namespace insonate
