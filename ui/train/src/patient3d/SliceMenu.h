#pragma once

#include <insonate/views/MprView.h>

#include <QMenu>
#include <functional>
#include <vector>

class QActionGroup;

namespace insonate::ui {
class ValueSlider;
}

namespace insonate::train {

/// Display of a slice of the CT: window and level, structures over it, fit.
class SliceMenu : public QMenu {
 public:
  SliceMenu(views::MprView& slice, QWidget* parent);

  /// A further slice that is shown as this one.
  void addSlice(views::MprView& slice) { others_.push_back(&slice); }
  /// One of views::windowLevelPresets().
  void choose(int preset);
  /// Called when a preset was chosen.
  void setChosen(std::function<void(views::WindowLevel)> listener) { chosen_ = std::move(listener); }

 private:
  void addStructures();
  void refresh();

  void forAll(const std::function<void(views::MprView&)>& act);

  views::MprView& slice_;
  std::vector<views::MprView*> others_;
  QActionGroup* presets_;
  ui::ValueSlider* opacity_ = nullptr;
  std::function<void(views::WindowLevel)> chosen_;
};

}  // namespace insonate::train
