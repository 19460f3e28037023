#pragma once

#include <QWidget>

class QCheckBox;

namespace insonate::ui {
class Commands;
class ValueSlider;
}  // namespace insonate::ui

namespace insonate::train {

class ImagingModel;

/// The controls' section about color Doppler: on or off, scale, gain, steering, wall filter, inversion and power.
class ColorControls final : public QWidget {
  Q_OBJECT

 public:
  ColorControls(ImagingModel& imaging, const ui::Commands& commands, QWidget* parent = nullptr);

 private:
  QCheckBox* box(const char* object, const QString& text, const QString& toolTip);
  ui::ValueSlider* slider(const char* object, const QString& name, const QString& unit, const QString& hint);
  void apply();
  void refresh();

  ImagingModel& imaging_;
  QCheckBox *on_, *invert_, *power_;
  ui::ValueSlider *scale_, *gain_, *steering_, *wallFilter_;
  bool refreshing_ = false;
  double shownScale_cmps_ = 0, shownFilter_Hz_ = 0;  ///< values of the sliders after refresh()
};

}  // namespace insonate::train
