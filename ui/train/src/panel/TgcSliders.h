#pragma once

#include <QWidget>
#include <array>
#include <functional>

namespace insonate::train {

/// Time-gain compensation as on a console: eight sliders from the face down, drawn close together, so that they read as
/// a curve. Drag across them to draw one; a double click resets a slider, with shift all of them; arrow keys work too.
class TgcSliders : public QWidget {
 public:
  static constexpr double kMost_dB = 20;

  explicit TgcSliders(QWidget* parent = nullptr);

  void setValues(const std::array<double, 8>& tgc_dB);  ///< each -20..20; calls nobody
  const std::array<double, 8>& values() const { return tgc_dB_; }
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
  int rowAt(int y) const;
  double x(double dB) const;
  void change(int row, double dB);

  std::array<double, 8> tgc_dB_{};
  int row_ = 0;  ///< the one that arrow keys change
  std::function<void()> changed_;
};

}  // namespace insonate::train
