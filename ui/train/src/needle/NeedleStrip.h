#pragma once

#include "../model/HandsControl.h"

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

/// The line under the image during an attempt with the needle of mouse and keys: takes it, advances, withdraws and
/// angles it. The panel with all its numbers may be scrolled out of sight on a small screen. Hidden while a device
/// holds the needle.
class NeedleStrip final : public QWidget {
  Q_OBJECT

 public:
  NeedleStrip(HandsControl& hands, NeedleMotion& needle, NeedleTray& tray, const ui::Commands& commands,
              QWidget* parent = nullptr);

 private:
  void addMove(QHBoxLayout& row, const char* object, const QString& text, NeedleAxis axis, double step,
               const QString& says);
  void refresh();

  HandsControl& hands_;
  NeedleMotion& needle_;
  NeedleTray& tray_;
  std::vector<QPushButton*> moves_;
};

}  // namespace insonate::train
