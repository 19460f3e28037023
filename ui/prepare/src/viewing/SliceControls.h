#pragma once

#include <QWidget>

class QCheckBox;
class QComboBox;

namespace insonate::ui {
class Commands;
class ValueSlider;
}  // namespace insonate::ui

namespace insonate::prepare {

struct PrepareModel;

/// Controls for the display of slices: window and level of the CT, and the labels over the CT.
class SliceControls : public QWidget {
 public:
  /// `commands`: their keys appear in tooltips.
  SliceControls(PrepareModel& shared, const ui::Commands& commands);

 private:
  void refresh();

  PrepareModel& shared_;
  QComboBox* preset_;
  ui::ValueSlider *window_, *level_, *opacity_;
  QComboBox* style_;
  ui::ValueSlider* width_;
  QCheckBox *labels_, *places_;
  bool showing_ = false;
};

}  // namespace insonate::prepare
