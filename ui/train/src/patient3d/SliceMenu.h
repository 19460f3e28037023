#pragma once

#include <insonate/views/MprView.h>

#include <QMenu>
#include <functional>
#include <vector>

class QActionGroup;

namespace insonate::ui {
class Commands;
class ValueSlider;
}  // namespace insonate::ui

namespace insonate::train {

/// Menu for the display of a CT slice: window and level, overlaid structures, fit.
class SliceMenu : public QMenu {
 public:
  SliceMenu(views::MprView& slice, const ui::Commands& commands, QWidget* parent);

  /// Adds a slice that gets the same display settings.
  void addSlice(views::MprView& slice) { others_.push_back(&slice); }
  /// Applies a preset of views::windowLevelPresets().
  void choose(int preset);
  /// Sets a listener that is called when a preset is chosen.
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
