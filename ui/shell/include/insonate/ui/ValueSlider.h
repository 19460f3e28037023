#pragma once

#include <QString>
#include <QWidget>

class QLineEdit;

namespace insonate::ui {

/// Range, default and step of a ValueSlider.
struct ValueRange {
  double least = 0, most = 1;  ///< minimum and maximum, least < most
  double usual = 0;            ///< default, restored by a double click
  double step = 0.1;           ///< step of arrows and of the wheel, above 0; Page up and down make ten steps
  int decimals = 1;            ///< digits shown and kept, 0 to 6
};

/// A number with name and unit: a slider, and a field in which the number can be typed. Double click on the slider or
/// the name restores the default. Arrows change the number by one step; so does the wheel, with Ctrl or with keyboard
/// focus.
class ValueSlider : public QWidget {
  Q_OBJECT

 public:
  /// `unit` as printed, "mm"; empty for a plain number. `hint` says in a few words what the number does.
  ValueSlider(const QString& name, const QString& unit, const ValueRange& range, const QString& hint = {},
              QWidget* parent = nullptr);

  double value() const { return value_; }
  /// Sets the value, clamped to the range; emits valueChanged() if it differs. A number that is not finite is ignored.
  void setValue(double value);
  const ValueRange& range() const { return range_; }
  /// Sets the range and clamps the value to it.
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
