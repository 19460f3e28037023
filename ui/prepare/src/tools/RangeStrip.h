#pragma once

#include <insonate/segmentation/Region.h>
#include <insonate/views/HuHistogram.h>
#include <insonate/views/Theme.h>

#include <QWidget>

namespace insonate::prepare {

/// Shows a range of Hounsfield units over the CT's histogram. The user can drag each end, or both together by the band
/// between them.
class RangeStrip : public QWidget {
  Q_OBJECT

 public:
  explicit RangeStrip(QWidget* parent = nullptr);

  void setHistogram(const views::HuHistogram& histogram);
  void setRange(HuRange range);
  void setColor(views::Color color);
  /// Converts between Hounsfield units and x positions on the strip.
  double placeOf(double hu) const;
  double huAt(double x) const;

  QSize sizeHint() const override { return {280, 64}; }
  QSize minimumSizeHint() const override { return {160, 56}; }

 Q_SIGNALS:
  /// Emitted when the user has dragged the range.
  void dragged(insonate::HuRange range);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  enum class Part { None, Low, High, Both };
  Part partAt(double x) const;
  QRectF field() const;

  views::HuHistogram histogram_;
  HuRange range_{0, 100}, before_;
  views::Color color_ = views::theme::kAccent;
  Part held_ = Part::None;
  double from_HU_ = 0;  ///< value under the pointer when the drag began
};

}  // namespace insonate::prepare
