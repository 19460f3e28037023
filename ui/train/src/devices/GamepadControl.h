#pragma once

#include "../model/HapticControl.h"
#include "GamepadMap.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>

class QSettings;

namespace insonate::ui {
class Commands;
}

namespace insonate::train {

struct TrainModel;

/// Moves probe and needle with the two halves of a game controller, in the way in which keys move them, and lets the
/// controller vibrate when the needle meets or punctures a structure. The library for controllers is started when the
/// devices are shown, or when a controller is assigned to a tool.
class GamepadControl final : public QObject {
  Q_OBJECT

 public:
  using MakePort = std::function<std::unique_ptr<GamepadPort>()>;

  GamepadControl(TrainModel& model, ui::Commands& commands, MakePort makePort, QObject* parent = nullptr);
  ~GamepadControl() override;

  /// Begins to look for controllers.
  void start();
  /// The controller; null before start().
  Gamepads* gamepads() const { return gamepads_.get(); }
  const GamepadMap& map() const { return map_; }
  void setMap(const GamepadMap& map) { map_ = map; }

  void save(QSettings& settings) const;
  void restore(QSettings& settings);

 private:
  /// One half of the controller.
  struct Half {
    double across = 0, along = 0, trigger = 0;  ///< after the dead zone, -1 to 1; the trigger 0 to 1
    bool isShifted = false;
  };
  void checkAssigned();
  void look();
  Half halfOf(const GamepadReading& reading, int side) const;
  void moveProbe(const Half& half, double step_s);
  void moveNeedle(const Half& half, double step_s);
  void press(const GamepadReading& reading);
  int sideOf(HapticTool hand) const;
  void feel();

  TrainModel& model_;
  ui::Commands& commands_;
  MakePort makePort_;
  std::unique_ptr<Gamepads> gamepads_;
  GamepadMap map_;
  GamepadReading before_;
  double pressed_mm_ = 0;  ///< compression that the trigger has commanded
  double rest_mm_ = 0;     ///< compression before the trigger was pulled
  bool moved_ = false;     ///< true: the probe was moved in the last step
  bool touched_ = false;   ///< true: the needle met a resistance
  QTimer timer_;
  QElapsedTimer clock_;
};

}  // namespace insonate::train
