#pragma once

#include <insonate/procedure/LineInstruments.h>

#include <QTimer>
#include <QWidget>
#include <vector>

class QBoxLayout;
class QComboBox;
class QLabel;
class QMenu;
class QPushButton;

namespace insonate::ui {
class Commands;
}

namespace insonate::train {

class AttemptControl;
class HapticControl;
class WireHand;

/// The line under the image for everything that follows the puncture: choice of wire, dilator or catheter, its advance
/// and withdrawal, and the menu of acts. With a haptic device, the choice also says what the device moves: the needle
/// or an instrument. Visible during an attempt at a procedure with a line.
class LineStrip final : public QWidget {
  Q_OBJECT

 public:
  LineStrip(AttemptControl& attempt, HapticControl& hands, const ui::Commands& commands, QWidget* parent = nullptr);

  /// Chooses the next instrument of the list.
  void chooseNext();
  /// Moves the chosen instrument into the body; out of it if `by_mm` is negative. `isHeldDown`: a key or button that is
  /// held down repeats the move; it ends at a stop.
  void move(double by_mm, bool isHeldDown);
  /// Opens the menu of acts.
  void openActs();

 private:
  void buildMoves(QBoxLayout& row, const ui::Commands& commands);
  void fillMenu();
  void addAct(QMenu& menu, LineAct act, int lumen = 1);
  Instrument chosen() const;
  void takeChosen();
  void holdDown(double by_mm);
  void offerNeedle();
  void refresh();

  AttemptControl& attempt_;
  WireHand* hand_;
  bool wasShown_ = false;
  bool isStopped_ = false;  ///< the last move met a stop
  double heldBy_mm_ = 0;    ///< the move that repeating_ repeats
  QTimer repeating_;
  std::vector<QPushButton*> moves_;  ///< advance and withdraw
  QComboBox* instrument_;
  QPushButton* acts_;
  QMenu* menu_;
  QLabel* depth_;
};

}  // namespace insonate::train
