#pragma once

#include "../model/HapticControl.h"

#include <QWidget>

class QPushButton;

namespace insonate::ui {
class Commands;
}

namespace insonate::train {

class NeedleMotion;

/// Two buttons that take the needle in-plane or out-of-plane, or put it away. The button for the plane of the present
/// needle is checked.
class NeedlePlaneButtons final : public QWidget {
  Q_OBJECT

 public:
  /// The buttons are called `object` + "Along" and `object` + "Across".
  NeedlePlaneButtons(const QString& object, HapticControl& hands, NeedleMotion& needle, const ui::Commands& commands,
                     QWidget* parent);

 private:
  QPushButton* planeButton(const QString& object, const QString& text, const QString& says, NeedlePlane plane);
  void refresh();

  HapticControl& hands_;
  NeedleMotion& needle_;
  QPushButton *along_, *across_;
};

}  // namespace insonate::train
