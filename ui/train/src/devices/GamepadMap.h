#pragma once

#include <insonate/haptics/Gamepad.h>

#include <QString>
#include <array>

class QSettings;

namespace insonate::train {

/// Function of a control of a game controller.
enum class GamepadFunction {
  LeftAcross,
  LeftAlong,
  LeftTrigger,
  LeftShift,
  RightAcross,
  RightAlong,
  RightTrigger,
  RightShift,
  TakeNeedle,
  Freeze,
  Aspirate,
  Home
};
inline constexpr int kGamepadFunctions = 12, kGamepadAxes = 6, kGamepadButtons = 15;

/// Assignment of controls to functions. A control is an axis (0 to 5, GamepadAxis) or a button (6 to 20,
/// GamepadButton).
class GamepadMap {
 public:
  int controlOf(GamepadFunction function) const { return controls_[std::size_t(function)]; }
  void setControl(GamepadFunction function, int control) { controls_[std::size_t(function)] = control; }
  /// Returns the position of the function's control: -1 to 1 for a stick, positive to the right and up; else 0 to 1.
  double valueOf(GamepadFunction function, const GamepadReading& reading) const;

  void save(QSettings& settings) const;
  /// Reads a map; invalid entries keep their defaults.
  void restore(QSettings& settings);
  bool operator==(const GamepadMap&) const = default;

 private:
  std::array<int, kGamepadFunctions> controls_{0, 1, 4, 6 + 9, 2, 3, 5, 6 + 10, 6 + 2, 6 + 0, 6 + 1, 6 + 3};
};

/// Names for the user.
QString nameOfFunction(GamepadFunction function);
QString nameOfControl(int control);

}  // namespace insonate::train
