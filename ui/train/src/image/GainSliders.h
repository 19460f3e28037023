#pragma once

#include <QWidget>
#include <array>
#include <functional>

namespace insonate::train {

/// Gain curve as on a console: eight sliders that are drawn close together. Vertical sliders are stacked and set the
/// gain by depth (TGC), from the probe's face down; horizontal sliders set the lateral gain from left to right.
/// Dragging across the sliders draws a curve. A double click resets one slider, a double click with Shift all sliders;
/// arrow keys change the selected slider.
class GainSliders : public QWidget {
 public:
  static constexpr double kMost_dB = 20;

  /// `along`: Qt::Vertical for stacked sliders. `name`: label. `tooltip`: explanation.
  GainSliders(Qt::Orientation along, const QString& name, const QString& tooltip, QWidget* parent = nullptr);

  void setValues(const std::array<double, 8>& gain_dB);  ///< each -20 to 20; does not call the listener
  const std::array<double, 8>& values() const { return gain_dB_; }
  void setChanged(std::function<void()> listener) { changed_ = std::move(listener); }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  bool isStacked() const { return along_ == Qt::Vertical; }
  int sliderAt(QPoint place) const;
  double gainAt(QPoint place) const;
  /// Position in pixels; the sliders' centers have the numbers 0 to 7.
  QPointF placeOf(double slider, double gain_dB) const;
  void change(int slider, double gain_dB);

  Qt::Orientation along_;
  std::array<double, 8> gain_dB_{};
  int slider_ = 0;  ///< number of the slider that arrow keys change
  std::function<void()> changed_;
};

}  // namespace insonate::train
