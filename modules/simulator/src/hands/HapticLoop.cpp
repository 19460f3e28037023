#include "hands/HapticLoop.h"

#include <insonate/tissue/NeedleTable.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace insonate {
namespace {

constexpr std::chrono::milliseconds kStep{16};
/// A smaller motion does not move an image, since encoders tremble.
constexpr double kStill_mm = 0.02, kStill_rad = 0.0005;
/// A larger motion is not that of a hand (see NeedleMechanics).
constexpr double kFar_mm = 40;
constexpr double kTestForce_N = 1, kTest_s = 1, kRamp_s = 0.15;

std::int64_t monotonic_ns() {
  return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

bool sameAsSeen(const Transform& a, const Transform& b) {
  double turn = 0;
  for (int i = 0; i < 3; ++i) turn = std::max(turn, norm(a.linear.column[i] - b.linear.column[i]));
  return norm(a.offset - b.offset) < kStill_mm && turn < kStill_rad;
}

/// Rotation from one attitude to another as axis times angle; exact for small angles, and close up to a right angle.
Vec3 turnBetween(const Mat3& from, const Mat3& to) {
  Vec3 sum;
  for (int i = 0; i < 3; ++i) sum = sum + cross(from.column[i], to.column[i]);
  const double sine = 0.5 * norm(sum);
  return sine > 1e-12 ? sum * (0.5 * std::asin(std::min(sine, 1.0)) / sine) : Vec3{};
}

}  // namespace

HapticSession::Impl::Impl(std::shared_ptr<haptics::HidBus> bus)
    : hub(std::move(bus)),
      mice{std::make_shared<MouseDevice>("mouse:probe", "Mouse and keyboard"),
           std::make_shared<MouseDevice>("mouse:needle", "Mouse and keyboard")} {
  setup.needle = loadNeedleTable(needlePresetNames().front()).value_or(NeedleTable{});
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

HapticSession::Impl::~Impl() {
  thread_.request_stop();
  wake();
  thread_.join();
  // Devices receive their last zero force before the hub releases them.
  servo = nullptr;
}

void HapticSession::Impl::wake() {
  changed_.notify_all();
}

void HapticSession::Impl::assignDevice(HapticTool hand, std::shared_ptr<HapticDevice> device, ToolSetup handSetup) {
  std::unique_ptr<ServoThread> ended;
  {
    const std::lock_guard lock(mutex);
    if (isMouseAssigned(hand) && device != devices[hand]) mice[hand]->setConnected(false);
    if (test_ && test_->hand == hand) test_->device->push({}), test_.reset();
    if (device) handSetup.limits = device->info().limits;
    devices[hand] = std::move(device);
    if (hand == kNeedleTool && !devices[hand]) hideNeedle();
    setup.tools[hand] = handSetup;
    if (devices[0] || devices[1]) {
      if (!servo) {
        servo = std::make_unique<ServoThread>();
        servo->setListener(attempt);
      }
      servo->configure(setup);
      servo->assignDevice(hand, devices[hand]);
    } else {
      ended = std::move(servo);
    }
  }
  wake();
}

void HapticSession::Impl::moveByMouse(HapticTool hand, const Transform& patientFromTool) {
  const Transform before = std::exchange(mouseAt[hand], patientFromTool);
  if (!servo || before == patientFromTool) return;
  if (isMouseAssigned(hand)) return moveMouse(hand, before, patientFromTool);
  SimulatedDevice* device = simulated(hand);
  if (!device) return;
  const ToolSetup& held = setup.tools[hand];
  const Transform deviceFromStylus = inverted(held.patientFromDevice) * patientFromTool * inverted(held.stylusFromTool);
  device->setTarget({0, deviceFromStylus.offset - held.apart_mm, deviceFromStylus.linear});
}

void HapticSession::Impl::moveMouse(HapticTool hand, const Transform& before, const Transform& patientFromTool) {
  const Vec3 way_mm = patientFromTool.offset - before.offset;
  const Vec3 turn_rad = turnBetween(before.linear, patientFromTool.linear);
  const Vec3 from_mm = patientFromTool.offset - mousePlace_mm[hand];
  const double max_mm = 0.45 * MouseDevice::kWorkspace_mm;
  const bool beyond = std::abs(from_mm.x) > max_mm || std::abs(from_mm.y) > max_mm || std::abs(from_mm.z) > max_mm;
  if (norm(way_mm) < kFar_mm && norm(turn_rad) < 0.5 && !beyond) {
    mice[hand]->moveBy(way_mm);
    mice[hand]->turnBy(turn_rad);
    return;
  }
  placeMouse(hand, patientFromTool);
}

/// The frame of mouse and keys is the patient's: a position is one message, of which no tick sees a half.
void HapticSession::Impl::placeMouse(HapticTool hand, const Transform& patientFromTool) {
  mousePlace_mm[hand] = patientFromTool.offset;
  mice[hand]->placeAt(patientFromTool);
}

void HapticSession::Impl::setNeedleFixed(bool held) {
  const std::lock_guard lock(mutex);
  if (std::exchange(setup.needleFixed, held) == held || !servo) return;
  if (!held) regrip(servo->latest());
  servo->configure(setup);
}

void HapticSession::Impl::setFreeHand(FreeHand hand, const WireGrip& wire) {
  const std::lock_guard lock(mutex);
  setup.freeHand = hand, setup.wire = wire;
  if (servo) servo->configure(setup);
}

/// The stylus in its present pose holds the needle in its present pose. Motions stay those of the device.
void HapticSession::Impl::regrip(const ServoSnapshot& now) {
  // Mouse and keys did not move.
  if (!now.present[kNeedleTool] || isMouseAssigned(kNeedleTool)) return;
  ToolSetup& hand = setup.tools[kNeedleTool];
  const Transform& needle = now.output.tools[kNeedleTool].patientFromTool;
  const Transform& stylus = now.states[kNeedleTool].deviceFromStylus;
  const Mat3 turned = hand.patientFromDevice.linear;
  hand.stylusFromTool.linear = transposed(turned * stylus.linear) * needle.linear;
  hand.patientFromDevice.offset = needle.offset - turned * (hand.apart_mm + stylus * hand.stylusFromTool.offset);
}

void HapticSession::Impl::forgetTissue() {
  grid = nullptr, veins = nullptr;
  frame = nullptr;
  patches_.reset();
  maker_.forget();
  making_ = false;
}

void HapticSession::Impl::wantTissue(const Transform& patientFromTool) {
  center_mm_ = patientFromTool * Vec3{0, 0, GridMaker::kAhead_mm};
  maker_.want(labels, center_mm_);
  making_ = true;
}

void HapticSession::Impl::takeMade() {
  if (auto made = maker_.take()) {
    making_ = false;
    grid = made->grid, veins = made->veins;
  }
}

void HapticSession::Impl::takeTissue(const ServoSnapshot& now) {
  takeMade();
  const int tool = now.present[kNeedleTool] ? kNeedleTool : kProbeTool;
  if (!labels || making_ || !now.present[tool] || now.output.needle.inBody) return;
  const Transform& held = now.output.tools[tool].patientFromTool;
  if (norm(held * Vec3{0, 0, GridMaker::kAhead_mm} - center_mm_) > GridMaker::kElsewhere_mm) wantTissue(held);
}

void HapticSession::Impl::shapesOf(const LiveFrame& of) {
  const ProbeFace face = probeFaceOf(of.setup->probe, of.setup->mechanics);
  if (setup.shapes.faceHalfWidth_mm == face.width_mm / 2) return;
  setup.shapes.faceHalfWidth_mm = face.width_mm / 2;
  if (servo) servo->configure(setup);
}

void HapticSession::Impl::takeFrame() {
  auto latest = imaging ? imaging->latest() : nullptr;
  if (!latest || latest == frame || !skin) return;
  frame = std::move(latest);
  shapesOf(*frame);
  if (frame->setup->mechanics.model != kNoDeformation)
    patches_.learn(*skin, probeFaceOf(frame->setup->probe, frame->setup->mechanics), frame->patientFromProbe,
                   frame->press);
}

void HapticSession::Impl::drive(const ServoSnapshot& now) {
  if (!imaging || isMouseAssigned(kProbeTool) || !now.present[kProbeTool]) return;
  const Transform& held = now.output.tools[kProbeTool].patientFromTool;
  if (sameAsSeen(held, driven_)) return;
  driven_ = held;
  imaging->setPose(held);
}

void HapticSession::Impl::showNeedle(const ServoSnapshot& now) {
  if (!imaging) return;
  if (!now.present[kNeedleTool]) return hideNeedle();
  const Transform& held = now.output.tools[kNeedleTool].patientFromShown;
  Needle needle{.tip_mm = held.offset, .direction = held.linear.column[2], .bevelNormal = -held.linear.column[1]};
  needle.length_mm = setup.shapes.needleLength_mm;
  needle.radius_mm = setup.shapes.needleRadius_mm;
  const NeedleState& state = now.output.needle;
  std::optional<Tenting> tenting;
  if (state.tenting && state.tent_mm > kStill_mm)
    tenting = Tenting{.tip_mm = needle.tip_mm, .direction = needle.direction, .depth_mm = state.tent_mm};
  const bool still = needle_ && tenting.has_value() == tenting_.has_value() &&
                     norm(needle.tip_mm - needle_->tip_mm) < kStill_mm &&
                     norm(needle.direction - needle_->direction) < kStill_rad &&
                     norm(needle.bevelNormal - needle_->bevelNormal) < kStill_rad &&
                     (!tenting || std::abs(tenting->depth_mm - tenting_->depth_mm) < kStill_mm);
  if (still) return;
  needle_ = needle, tenting_ = tenting;
  imaging->setNeedle(needle, tenting);
}

void HapticSession::Impl::show(LiveImaging* in) {
  if (in != imaging)
    needle_.reset(), rods_ = nullptr, flush_.reset(), lungs_ = {};  // the new imaging has no instruments yet
  imaging = in;
  frame = nullptr;
}

void HapticSession::Impl::showAttempt(const LiveAttempt* of) {
  if (!imaging) return;
  const std::optional<SalineFlush> flush = of ? of->flush() : std::nullopt;
  const std::array<bool, 2> lungs = of ? of->pneumothorax() : std::array<bool, 2>{};
  SharedRods rods = of ? of->rods() : nullptr;
  if (std::exchange(lungs_, lungs) != lungs) imaging->setPneumothorax(lungs);
  if (std::exchange(flush_, flush) != flush) imaging->setFlush(flush);
  if (rods == rods_) return;
  rods_ = std::move(rods);
  imaging->setRods(rods_);
}

void HapticSession::Impl::hideNeedle() {
  if (std::exchange(needle_, std::nullopt) && imaging) imaging->setNeedle(std::nullopt);
}

LocalModel HapticSession::Impl::modelFor(const ServoSnapshot& now) const {
  LocalModel model;
  model.time_ns = monotonic_ns();
  model.grid = grid;
  if (frame) model.restFromPatient = frame->press.restFromPatient;
  if (skin && frame && now.present[kProbeTool])
    patches_.show(*skin, probeFaceOf(frame->setup->probe, frame->setup->mechanics),
                  now.output.tools[kProbeTool].patientFromTool, model);
  return model;
}

void HapticSession::Impl::pollPedal() {
  DeviceState state;
  if (!pedal || !pedal->pollState(state)) return;
  presses |= state.buttons & ~pedalDown;
  pedalDown = state.buttons;
}

void HapticSession::Impl::testForce(HapticTool hand, Vec3 force_N) {
  const std::lock_guard lock(mutex);
  if (!servo || !devices[hand] || test_ || !isFinite(force_N)) return;
  const double max_N = std::min({kTestForce_N, setup.tools[hand].userMaxForce_N, setup.tools[hand].limits.maxForce_N});
  const double length_N = norm(force_N);
  servo->assignDevice(hand, nullptr);
  test_ = Test{devices[hand], hand, length_N > max_N ? force_N * (max_N / length_N) : force_N,
               Clock::now() + kStep};  // the servo no longer pushes the device then
}

void HapticSession::Impl::goOnTesting() {
  if (!test_) return;
  const double t_s = std::chrono::duration<double>(Clock::now() - test_->begin).count();
  if (t_s < 0) return;
  DeviceState state;
  test_->device->pollState(state);
  const double share = std::clamp(std::min(t_s, kTest_s - t_s) / kRamp_s, 0.0, 1.0);
  test_->device->push({test_->force_N * share, {}});
  if (t_s < kTest_s) return;
  servo->assignDevice(test_->hand, test_->device);
  test_.reset();
}

void HapticSession::Impl::step() {
  pollPedal();
  if (!servo) return;
  goOnTesting();
  const ServoSnapshot now = servo->latest();
  takeTissue(now);
  takeFrame();
  drive(now);
  showNeedle(now);
  LocalModel model = modelFor(now);
  if (attempt) {
    const LiveAttempt::Surroundings around{model.grid,
                                           veins,
                                           skin,
                                           model.restFromPatient,
                                           frame ? frame->setup->settings.depth_mm : 0,
                                           labels,
                                           now.output.needle,
                                           now.output.tools[kNeedleTool].patientFromTool};
    attempt->addFrame(frame, around);
    attempt->setSurroundings(around);
    showAttempt(attempt.get());
  }
  servo->setLocalModel(std::move(model));
}

void HapticSession::Impl::run(const std::stop_token& stop) {
  std::unique_lock lock(mutex);
  while (!stop.stop_requested()) {
    if (!changed_.wait(lock, stop, [this] { return busy() || making_; })) return;
    step();
    if (!servo && making_) takeMade();
    lock.unlock();
    std::this_thread::sleep_for(kStep);
    lock.lock();
  }
}

}  // namespace insonate
