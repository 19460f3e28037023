#pragma once

#include <insonate/views/UltrasoundView.h>

#include <QObject>

class QSettings;
class QWidget;

namespace insonate::train {

class AreaPlot;
class TissueStrip;
class CaseModel;
class DisclosureModel;
class LiveModel;
class StatusLine;

/// Display of the tissue's mechanics in the image's column: the strip of numbers, the curve, and grid and pressure
/// over the image, which are requested only while they are shown.
class TissueShown final : public QObject {
 public:
  /// The widgets are made in `column`, for a layout to take.
  TissueShown(StatusLine& status, DisclosureModel& disclosure, CaseModel& patientCase, LiveModel& live,
              views::UltrasoundView& image, QWidget* column);

  TissueStrip& strip() { return *strip_; }
  QWidget& curve() { return *curve_; }
  /// 0 grid, 1 pressure, 2 curve: shows it, or no longer.
  void toggle(int what);
  void save(QSettings& settings) const;
  void restore(QSettings& settings);

 private:
  QWidget* buildCurve(QWidget* column);
  void showPicture();
  void choose();
  /// Chosen, and disclosed.
  bool shows(int what) const;

  StatusLine& status_;
  DisclosureModel& disclosure_;
  CaseModel& patientCase_;
  LiveModel& live_;
  views::UltrasoundView& image_;
  TissueStrip* strip_;
  AreaPlot* plot_ = nullptr;
  QWidget* curve_;
  views::PictureTissue mesh_;
};

}  // namespace insonate::train
