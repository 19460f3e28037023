#pragma once

#include "RangeStrip.h"

class QSpinBox;

namespace insonate::prepare {

/// Editor of a range of Hounsfield units. The user can drag the range on the histogram, type two numbers, or split the
/// range at the threshold that separates the histogram best.
class RangeField : public QWidget {
  Q_OBJECT

 public:
  /// The child widgets have the object names `name`-from, `name`-to, `name`-strip, `name`-darker, `name`-brighter and
  /// `name`-all.
  explicit RangeField(const QString& name, QWidget* parent = nullptr);

  void setHistogram(const views::HuHistogram& histogram);
  void setColor(views::Color color) { strip_->setColor(color); }
  HuRange range() const { return range_; }
  void setRange(HuRange range);

 Q_SIGNALS:
  /// Emitted when the user has edited the range.
  void edited(insonate::HuRange range);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void edit(HuRange range);
  /// Splits the range at the threshold of Otsu's method, and keeps the brighter or the darker part.
  void part(bool brighter);

  RangeStrip* strip_;
  QSpinBox *from_, *to_;
  views::HuHistogram histogram_;
  HuRange range_{0, 100};
  bool showing_ = false;
};

}  // namespace insonate::prepare
