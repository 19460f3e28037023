#pragma once

#include <insonate/procedure/LineInstruments.h>

#include <QWidget>

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

/// The line under the image for everything that follows the puncture: choice of wire, dilator or catheter, its advance
/// and withdrawal, and the menu of acts. Visible during an attempt at a procedure with a line.
class LineStrip final : public QWidget {
  Q_OBJECT

 public:
  LineStrip(AttemptControl& attempt, const ui::Commands& commands, QWidget* parent = nullptr);

  /// Chooses the next instrument of the list.
  void chooseNext();
  /// Moves the chosen instrument into the body; out of it if `by_mm` is negative.
  void move(double by_mm);
  /// Opens the menu of acts.
  void openActs();

 private:
  void buildMoves(QBoxLayout& row, const ui::Commands& commands);
  void fillMenu();
  void addAct(LineAct act, int lumen = 1);
  Instrument chosen() const;
  void refresh();

  AttemptControl& attempt_;
  QComboBox* instrument_;
  QPushButton* acts_;
  QMenu* menu_;
  QLabel* depth_;
};

}  // namespace insonate::train
