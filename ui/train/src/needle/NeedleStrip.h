#pragma once

#include "../model/HapticControl.h"

#include <QWidget>
#include <vector>

class QHBoxLayout;
class QPushButton;

namespace insonate::ui {
class Commands;
}

namespace insonate::train {

class NeedleMotion;
class NeedleTray;

/// The line under the image with which mouse and keys take, advance, withdraw and angle the needle during an attempt.
/// On a small screen, the panel with all numbers of the needle may be scrolled out of sight. Hidden while a device
/// moves the needle.
class NeedleStrip final : public QWidget {
  Q_OBJECT

 public:
  NeedleStrip(HapticControl& hands, NeedleMotion& needle, NeedleTray& tray, const ui::Commands& commands,
              QWidget* parent = nullptr);

 private:
  void addMove(QHBoxLayout& row, const char* object, const QString& text, NeedleAxis axis, double step,
               const QString& says);
  void refresh();

  HapticControl& hands_;
  NeedleMotion& needle_;
  NeedleTray& tray_;
  std::vector<QPushButton*> moves_;
};

}  // namespace insonate::train
