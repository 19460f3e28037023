#pragma once

#include <insonate/views/UltrasoundView.h>

#include <QObject>

class QSettings;
class QWidget;

namespace insonate::ui {
class Commands;
}

namespace insonate::train {

class AreaPlot;
class TissueStrip;
class CaseModel;
class DisclosureModel;
class LiveModel;
class StatusLine;

/// Display of the tissue's mechanics in the image's column: a strip with numbers, the curve, and grid and pressure over
/// the image. Grid and pressure are requested from the simulator only while they are shown.
class TissueShown final : public QObject {
 public:
  /// The widgets become children of `column`; a layout can move them.
  TissueShown(StatusLine& status, DisclosureModel& disclosure, CaseModel& patientCase, LiveModel& live,
              views::UltrasoundView& image, ui::Commands& commands, QWidget* column);

  TissueStrip& strip() { return *strip_; }
  QWidget& curve() { return *curve_; }
  /// Shows or hides a display. `what`: 0 grid, 1 pressure, 2 curve.
  void toggle(int what);
  void save(QSettings& settings) const;
  void restore(QSettings& settings);

 private:
  QWidget* buildCurve(QWidget* column);
  void showPicture();
  void choose();
  /// Tells whether a display (`what` as in toggle()) is switched on and disclosed.
  bool shows(int what) const;

  StatusLine& status_;
  DisclosureModel& disclosure_;
  CaseModel& patientCase_;
  LiveModel& live_;
  views::UltrasoundView& image_;
  TissueStrip* strip_;
  AreaPlot* plot_ = nullptr;
  QWidget* curve_;
  views::TissueOverlay mesh_;
};

}  // namespace insonate::train
