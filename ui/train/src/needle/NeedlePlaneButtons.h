#pragma once

#include "../model/HandsControl.h"

#include <QWidget>

class QPushButton;

namespace insonate::ui {
class Commands;
}

namespace insonate::train {

class NeedleMotion;

/// Two buttons that take the needle in-plane or out-of-plane, or put it away; the plane of the needle in the hand is
/// checked.
class NeedlePlaneButtons final : public QWidget {
  Q_OBJECT

 public:
  /// The buttons are called `object` + "Along" and `object` + "Across". With `isProminent`, the button that takes the
  /// needle as it was last held stands out while no needle is in a hand.
  NeedlePlaneButtons(const QString& object, bool isProminent, HandsControl& hands, NeedleMotion& needle,
                     const ui::Commands& commands, QWidget* parent);

 private:
  QPushButton* planeButton(const QString& object, const QString& text, const QString& says, NeedlePlane plane);
  void refresh();

  HandsControl& hands_;
  NeedleMotion& needle_;
  bool isProminent_;
  QPushButton *along_, *across_;
};

}  // namespace insonate::train
