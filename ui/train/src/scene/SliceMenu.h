#pragma once

#include <insonate/views/MprView.h>

#include <QMenu>

class QActionGroup;

namespace insonate::ui {
class ValueSlider;
}

namespace insonate::train {

/// How a slice of the CT is shown: window and level, structures over it, fit.
class SliceMenu : public QMenu {
 public:
  SliceMenu(views::MprView& slice, QWidget* parent);

  /// One of views::windowLevelPresets().
  void choose(int preset);

 private:
  void addStructures();
  void refresh();

  views::MprView& slice_;
  QActionGroup* presets_;
  ui::ValueSlider* opacity_ = nullptr;
};

}  // namespace insonate::train
