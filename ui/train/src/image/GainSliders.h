#pragma once

#include <QWidget>
#include <array>
#include <functional>

namespace insonate::train {

/// Gain by place as on a console: eight sliders drawn close together, so that they read as a curve. Stacked vertically
/// they are gain by depth (TGC), from the face down; side by side, gain from the left to the right of the image. Drag
/// across them to draw a curve; a double click resets a slider, with Shift all of them; arrow keys work too.
class GainSliders : public QWidget {
 public:
  static constexpr double kMost_dB = 20;

  /// Vertical: stacked. `name` is the label, `tooltip` the explanation.
  GainSliders(Qt::Orientation along, const QString& name, const QString& tooltip, QWidget* parent = nullptr);

  void setValues(const std::array<double, 8>& gain_dB);  ///< each -20..20; calls nobody
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
  QPointF placeOf(double slider, double gain_dB) const;  ///< sliders are 0 to 7, their middles at whole numbers
  void change(int slider, double gain_dB);

  Qt::Orientation along_;
  std::array<double, 8> gain_dB_{};
  int slider_ = 0;  ///< the one that arrow keys change
  std::function<void()> changed_;
};

}  // namespace insonate::train
