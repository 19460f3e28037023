#include "GamepadControl.h"

#include "../model/TrainModel.h"

#include <insonate/ui/Commands.h>

#include <QAction>
#include <algorithm>
#include <cmath>
#include <utility>

namespace insonate::train {
namespace {

constexpr int kPadStep_ms = 16;
/// Sticks do not return exactly to the middle.
constexpr double kDead = 0.15;
constexpr double kSlide_mmPerS = 40, kTurn_degPerS = 60, kMaxPress_mm = 12;
/// Force on the needle that counts as contact.
constexpr double kContact_N = 0.25, kFree_N = 0.1;

/// Small deflections move slowly, for fine motions.
double bent(double deflection) {
  const double beyond = std::max(0.0, std::abs(deflection) - kDead) / (1 - kDead);
  return std::copysign(beyond * beyond, deflection);
}

}  // namespace

GamepadControl::GamepadControl(TrainModel& model, ui::Commands& commands, MakePort makePort, QObject* parent)
    : QObject(parent), model_(model), commands_(commands), makePort_(std::move(makePort)) {
  timer_.setInterval(kPadStep_ms);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, [this] { look(); });
  connect(&model_.hands, &HapticControl::handsChanged, this, [this] { checkAssigned(); });
  connect(&model_.hands, &HapticControl::needleMet, this, [this](const NeedleEvent&) {
    using namespace std::chrono_literals;
    if (gamepads_ && sideOf(kNeedleTool) >= 0) gamepads_->rumble(1, 90ms);
  });
}

GamepadControl::~GamepadControl() = default;

void GamepadControl::start() {
  if (gamepads_) return;
  gamepads_ = std::make_unique<Gamepads>(makePort_());
  for (const auto& hand : gamepads_->hands()) model_.hands.session().devices().add(hand);
}

/// Returns 0 for the left half, 1 for the right half, -1 if no controller moves the tool.
int GamepadControl::sideOf(HapticTool hand) const {
  const QString device = model_.hands.choice().device(hand);
  if (!gamepads_ || device.isEmpty()) return -1;
  for (int side = 0; side < 2; ++side)
    if (device == QLatin1String(gamepads_->hands()[std::size_t(side)]->info().id.c_str())) return side;
  return -1;
}

void GamepadControl::checkAssigned() {
  const DeviceChoice& choice = model_.hands.choice();
  const auto isGamepad = [&](HapticTool hand) { return choice.device(hand).startsWith(QLatin1String(kGamepadIds)); };
  const bool isAssigned = isGamepad(kProbeTool) || isGamepad(kNeedleTool);
  if (isAssigned) start();
  if (isAssigned == timer_.isActive()) return;
  pressed_mm_ = 0;
  before_ = {};
  isAssigned ? (clock_.start(), timer_.start()) : timer_.stop();
}

GamepadControl::Half GamepadControl::halfOf(const GamepadReading& reading, int side) const {
  using enum GamepadFunction;
  const auto value = [&](GamepadFunction left, GamepadFunction right) {
    return map_.valueOf(side == 0 ? left : right, reading);
  };
  return {bent(value(LeftAcross, RightAcross)), bent(value(LeftAlong, RightAlong)),
          bent(std::abs(value(LeftTrigger, RightTrigger))), value(LeftShift, RightShift) > 0.5};
}

void GamepadControl::look() {
  const double step_s = std::min(0.1, double(clock_.restart()) / 1000);
  const GamepadReading now = gamepads_->reading();
  if (const int side = sideOf(kProbeTool); side >= 0) moveProbe(halfOf(now, side), step_s);
  if (const int side = sideOf(kNeedleTool); side >= 0) {
    moveNeedle(halfOf(now, side), step_s);
    feel();
  }
  press(now);
  before_ = now;
}

void GamepadControl::moveProbe(const Half& half, double step_s) {
  const double press_mm = half.trigger * kMaxPress_mm;
  const bool presses = std::abs(press_mm - pressed_mm_) > 0.05 || (press_mm == 0 && pressed_mm_ > 0);
  const bool moves = half.across != 0 || half.along != 0 || presses;
  // One gesture lasts until the stick is released.
  if (moves && !moved_) model_.motion.beginGesture();
  moved_ = moves;
  // A press may end earlier, at bone; the release leads back to where the probe was.
  if (presses) {
    if (pressed_mm_ == 0) rest_mm_ = model_.motion.numbers().press_mm;
    pressed_mm_ = press_mm;
    model_.motion.move(HandAxis::Press, rest_mm_ + press_mm - model_.motion.numbers().press_mm);
  }
  if (half.across == 0 && half.along == 0) return;
  if (half.isShifted) {
    model_.motion.move(HandAxis::Rotation, half.across * kTurn_degPerS * step_s);
    model_.motion.move(HandAxis::Tilt, half.along * kTurn_degPerS * step_s);
  } else {
    model_.motion.slide(half.across * kSlide_mmPerS * step_s, half.along * kSlide_mmPerS * step_s);
  }
}

void GamepadControl::moveNeedle(const Half& half, double step_s) {
  if (!model_.hands.needleHand()) return;
  const auto move = [&](NeedleAxis axis, double amount) {
    if (amount != 0) model_.needle.move(axis, amount);
  };
  const double turn_deg = kTurn_degPerS * step_s, slide_mm = kSlide_mmPerS * step_s;
  if (half.isShifted) {
    move(NeedleAxis::Heading, half.across * turn_deg);
    move(NeedleAxis::Angle, half.along * turn_deg);
  } else if (!model_.hands.needle() || !model_.hands.needle()->state.inBody) {
    move(NeedleAxis::Lateral, half.across * slide_mm);
    move(NeedleAxis::Elevation, half.along * slide_mm);
  }
  move(NeedleAxis::Advance, (half.isShifted ? -1 : 1) * half.trigger * HapticControl::kAdvance_mmPerS * step_s);
}

void GamepadControl::press(const GamepadReading& reading) {
  const auto change = [&](GamepadFunction function) {
    return int(map_.valueOf(function, reading) > 0.5) - int(map_.valueOf(function, before_) > 0.5);
  };
  const auto perform = [&](GamepadFunction function, const char* command) {
    if (change(function) > 0) commands_.action(QLatin1String(command))->trigger();
  };
  using enum GamepadFunction;
  perform(TakeNeedle, "train.needle.take");
  perform(Freeze, "train.image.freeze");
  perform(Home, "train.probe.home");
  if (const int by = change(Aspirate)) Q_EMIT model_.hands.aspirateButtonChanged(by > 0);
}

/// A weak vibration when the needle meets a resistance.
void GamepadControl::feel() {
  using namespace std::chrono_literals;
  const auto& needle = model_.hands.needle();
  const double force_N = needle ? std::abs(needle->state.axial_N) : 0;
  if (force_N > kContact_N && !std::exchange(touched_, true)) gamepads_->rumble(0.25, 40ms);
  if (force_N < kFree_N) touched_ = false;
}

void GamepadControl::save(QSettings& settings) const {
  map_.save(settings);
}

void GamepadControl::restore(QSettings& settings) {
  map_.restore(settings);
  checkAssigned();
}

}  // namespace insonate::train
