#pragma once

#include <QDialog>
#include <vector>

class QComboBox;

namespace insonate::train {

class GamepadControl;

/// Window in which the user assigns the controls of the game controller to functions.
class GamepadDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit GamepadDialog(GamepadControl& control, QWidget* parent = nullptr);

 private:
  void refresh();

  GamepadControl& control_;
  std::vector<QComboBox*> controls_;  ///< index: GamepadFunction
};

}  // namespace insonate::train
