#pragma once

#include <insonate/views/UltrasoundView.h>

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <memory>

class QLabel;
class QPushButton;

namespace insonate::ui {
class Commands;
class ValueSlider;
class ViewWidget;
}  // namespace insonate::ui

namespace insonate::prepare {

struct PrepareModel;

/// The small ultrasound image computed from the labels, always visible.
class UltrasoundPane : public QWidget {
 public:
  /// `commands`: their keys appear in tooltips.
  UltrasoundPane(PrepareModel& shared, const ui::Commands& commands);

  ui::ViewWidget& widget() { return *widget_; }

 private:
  void showPicture();
  void showState();
  /// Writes into the black area what is computed until there is an image, and for how long already.
  void showNotice();
  void showPress();

  PrepareModel& shared_;
  std::shared_ptr<views::UltrasoundView> view_;
  std::shared_ptr<const void> shape_;  ///< setup for which the image was laid out
  ui::ViewWidget* widget_;
  ui::ValueSlider* press_;
  QLabel *state_, *pressed_;
  QPushButton *start_, *keep_;
  QElapsedTimer since_;  ///< began with the computation of the first image; invalid while no image is awaited
  QTimer tick_;
};

}  // namespace insonate::prepare
