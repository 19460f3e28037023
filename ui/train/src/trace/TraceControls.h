#pragma once

#include <QWidget>

class QCheckBox;

namespace insonate::ui {
class Commands;
class ValueSlider;
}  // namespace insonate::ui

namespace insonate::train {

class ImagingModel;
class TraceModel;

/// The controls' section about PW Doppler and M-mode.
class TraceControls final : public QWidget {
  Q_OBJECT

 public:
  TraceControls(ImagingModel& imaging, TraceModel& trace, const ui::Commands& commands, QWidget* parent = nullptr);

 private:
  QCheckBox* box(const char* object, const QString& text, const QString& toolTip);
  ui::ValueSlider* slider(const char* object, const QString& name, const QString& unit, const QString& hint);
  void apply();
  void refresh();
  void setRanges();

  ImagingModel& imaging_;
  TraceModel& trace_;
  QCheckBox *pw_, *mMode_;
  ui::ValueSlider *scale_, *baseline_, *gateLength_, *angle_, *steering_, *wallFilter_, *gain_, *sweep_;
  bool refreshing_ = false;
  double shownScale_cmps_ = 0, shownFilter_Hz_ = 0;  ///< values of the sliders after refresh()
};

}  // namespace insonate::train
