#include <insonate/haptics/Gamepad.h>

#define SDL_MAIN_HANDLED
#include <SDL.h>

#include <algorithm>

namespace insonate {
namespace {

constexpr int kAxes = 6, kButtons = 15;
constexpr SDL_GameControllerAxis kSdlAxes[kAxes] = {SDL_CONTROLLER_AXIS_LEFTX,       SDL_CONTROLLER_AXIS_LEFTY,
                                                    SDL_CONTROLLER_AXIS_RIGHTX,      SDL_CONTROLLER_AXIS_RIGHTY,
                                                    SDL_CONTROLLER_AXIS_TRIGGERLEFT, SDL_CONTROLLER_AXIS_TRIGGERRIGHT};
static_assert(int(GamepadButton::South) == SDL_CONTROLLER_BUTTON_A);
static_assert(int(GamepadButton::Right) == SDL_CONTROLLER_BUTTON_DPAD_RIGHT &&
              int(GamepadButton::Right) == kButtons - 1);

class SdlGamepads : public GamepadPort {
 public:
  ~SdlGamepads() override {
    if (pad_) SDL_GameControllerClose(pad_);
    if (isOpen_) SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
  }

  Result<void> open() override {
    SDL_SetMainReady();
    // The window's toolkit handles signals, and reads keys and mouse.
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
    if (SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) != 0)
      return fail(std::string("Game controllers cannot be used: ") + SDL_GetError() + ". Restart the program.");
    isOpen_ = true;
    SDL_GameControllerEventState(SDL_IGNORE);
    return {};
  }

  bool read(GamepadReading& reading, std::string& name) override {
    SDL_GameControllerUpdate();
    SDL_JoystickUpdate();
    if (pad_ && !SDL_GameControllerGetAttached(pad_)) SDL_GameControllerClose(std::exchange(pad_, nullptr));
    for (int i = 0, count = SDL_NumJoysticks(); !pad_ && i < count; ++i)
      if (SDL_IsGameController(i)) pad_ = SDL_GameControllerOpen(i);
    if (!pad_) return false;
    if (const char* known = SDL_GameControllerName(pad_)) name = known;
    for (int i = 0; i < kAxes; ++i)
      reading.axes[std::size_t(i)] = std::clamp(SDL_GameControllerGetAxis(pad_, kSdlAxes[i]) / 32767.0, -1.0, 1.0);
    for (int i = 0; i < kButtons; ++i)
      if (SDL_GameControllerGetButton(pad_, SDL_GameControllerButton(i))) reading.buttons |= 1U << unsigned(i);
    return true;
  }

  void rumble(double strength, std::chrono::milliseconds duration) override {
    const auto level = Uint16(strength * 65535);
    if (pad_) SDL_GameControllerRumble(pad_, level, level, Uint32(duration.count()));
  }

 private:
  bool isOpen_ = false;
  SDL_GameController* pad_ = nullptr;
};

}  // namespace

std::unique_ptr<GamepadPort> sdlGamepads() {
  return std::make_unique<SdlGamepads>();
}

}  // namespace insonate
