#include <insonate/haptics/Gamepad.h>

#include <algorithm>
#include <utility>

namespace insonate {

GamepadDevice::GamepadDevice(std::string id, std::string name)
    : info_{std::move(id),
            std::move(name),
            DeviceKind::kController,
            {.sensedAxes = 3, .workspace_mm = {}, .rate_Hz = 1000.0 / double(Gamepads::kInterval.count())}} {}

std::string GamepadDevice::error() const {
  const std::lock_guard lock(mutex_);
  return sentence_;
}

DeviceQuality GamepadDevice::quality() const {
  // On average, a motion waits for half the interval between two readings.
  if (phase() != DevicePhase::kStreaming) return {0, 0, {}};
  return {double(Gamepads::kInterval.count()) / 2, 1, {}};
}

void GamepadDevice::setPhase(DevicePhase phase, std::string sentence) {
  const std::lock_guard lock(mutex_);
  sentence_ = std::move(sentence);
  phase_ = phase;
}

Gamepads::Gamepads(std::unique_ptr<GamepadPort> port)
    : port_(std::move(port)),
      hands_{std::make_shared<GamepadDevice>("gamepad:left", "Controller: left hand"),
             std::make_shared<GamepadDevice>("gamepad:right", "Controller: right hand")} {
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

GamepadReading Gamepads::reading() const {
  const std::lock_guard lock(mutex_);
  return reading_;
}

void Gamepads::rumble(double strength, std::chrono::milliseconds duration) {
  rumbles_.post({std::clamp(strength, 0.0, 1.0), duration});
}

void Gamepads::setPhases(DevicePhase phase, const std::string& sentence) {
  for (const auto& hand : hands_)
    if (hand->phase() != phase) hand->setPhase(phase, sentence);
}

void Gamepads::run(const std::stop_token& stop) {
  if (const auto opened = port_->open(); !opened) return setPhases(DevicePhase::kFailed, opened.error().message);
  bool wasThere = false;
  while (!stop.stop_requested()) {
    GamepadReading now;
    std::string name;
    const bool isThere = port_->read(now, name);
    if (isThere) {
      setPhases(DevicePhase::kStreaming, {});
      for (const auto& hand : hands_) hand->countReading();
      if (const auto wish = rumbles_.takeLatest()) port_->rumble(wish->strength, wish->duration);
    } else if (std::exchange(wasThere, false)) {
      setPhases(DevicePhase::kLost, "The game controller was disconnected. Connect it again.");
    }
    wasThere = wasThere || isThere;
    {
      const std::lock_guard lock(mutex_);
      reading_ = isThere ? now : GamepadReading{};
    }
    std::this_thread::sleep_for(kInterval);
  }
  port_ = nullptr;  // on the thread that opened it
}

}  // namespace insonate
