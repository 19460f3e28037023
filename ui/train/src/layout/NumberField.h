#pragma once

#include <QLineEdit>
#include <QString>
#include <functional>

namespace insonate::train {

/// A field for a number with a unit. The user types the number, or changes it by arrow keys and, while the field has
/// the keyboard focus, by the wheel. Enter applies the number. Invalid input is rejected with a sentence under the
/// field, and the former number is restored.
class NumberField : public QLineEdit {
 public:
  struct Range {
    double low, high, step;
    int decimals = 1;
  };
  /// `unit`: text that follows the number, including a space if the unit needs one.
  NumberField(const QString& name, const QString& unit, const Range& range, QWidget* parent = nullptr);

  /// Shows a value, unless the user is typing. Emits nothing.
  void show(double value);
  double value() const { return value_; }
  void setTyped(std::function<void(double value)> listener) { typed_ = std::move(listener); }
  void setRefused(std::function<void(const QString& sentence)> listener) { refused_ = std::move(listener); }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  QString words(double value) const;
  void apply();
  void step(double steps);
  void write();

  QString name_, unit_;
  Range range_;
  double value_ = 0, wheelRest_ = 0;
  std::function<void(double)> typed_;
  std::function<void(const QString&)> refused_;
};

}  // namespace insonate::train
