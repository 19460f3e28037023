#pragma once

#include <QString>
#include <QWidget>

class QLineEdit;

namespace insonate::ui {

/// Values that a ValueSlider can take.
struct ValueRange {
  double least = 0, most = 1;  ///< least < most
  double usual = 0;            ///< what a double click gives back
  double step = 0.1;           ///< of arrows and wheel, above 0; ten of them with Page up and down
  int decimals = 1;            ///< digits shown and kept, 0..6
};

/// One number with its name and unit: a slider, and the number itself, which takes typing. Double click on the slider
/// or on the name gives the usual value back; wheel and arrows step.
class ValueSlider : public QWidget {
  Q_OBJECT

 public:
  /// `unit` as printed, "mm"; empty for a plain number. `hint` says in a few words what the value does.
  ValueSlider(const QString& name, const QString& unit, const ValueRange& range, const QString& hint = {},
              QWidget* parent = nullptr);

  double value() const { return value_; }
  /// Sets the value, clamped to the range; emits valueChanged() if it differs. A number that is not finite is ignored.
  void setValue(double value);
  const ValueRange& range() const { return range_; }
  /// The value is brought into the new range.
  void setRange(const ValueRange& range);
  void reset() { setValue(range_.usual); }

 Q_SIGNALS:
  void valueChanged(double value);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  class Track;
  void typed();
  void showValue();
  void fitNumber();
  void describe();
  QString text(double value) const;

  QString name_, unit_, hint_;
  ValueRange range_;
  double value_ = 0;
  QWidget* label_;
  QLineEdit* number_;
  Track* track_;
};

}  // namespace insonate::ui
