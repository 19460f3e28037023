#pragma once

#include <QString>
#include <QWidget>

class QLineEdit;

namespace insonate::ui {

/// Range, default and step of a ValueSlider.
struct ValueRange {
  double minimum = 0, maximum = 1;  ///< range of the slider; minimum < maximum
  double defaultValue = 0;          ///< value, which a double click restores
  double step = 0.1;  ///< step of the arrow keys and of the wheel, above 0; Page Up and Page Down make ten steps
  int decimals = 1;   ///< number of decimals to which the value is rounded and shown, 0 to 6
};

/// A control for a number with name and unit: a slider, and a field in which the number can be typed. A double click on
/// the slider or the name restores the default. Arrow keys change the number by one step; so does the wheel, if Ctrl is
/// held or the control has the keyboard focus.
class ValueSlider : public QWidget {
  Q_OBJECT

 public:
  /// `unit`: text after the number, e.g. "mm"; empty for a number without unit. `hint`: effect of the number, in a few
  /// words.
  ValueSlider(const QString& name, const QString& unit, const ValueRange& range, const QString& hint = {},
              QWidget* parent = nullptr);

  double value() const { return value_; }
  /// Sets the value, clamped to the range. Emits valueChanged() if the value has changed. Ignores a number that is not
  /// finite.
  void setValue(double value);
  const ValueRange& range() const { return range_; }
  /// Sets the range and clamps the value to it.
  void setRange(const ValueRange& range);
  void reset() { setValue(range_.defaultValue); }

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
