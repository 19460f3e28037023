#pragma once

#include <QCoreApplication>
#include <QLineEdit>
#include <QToolTip>
#include <QValidator>
#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace insonate::ui {

/// A QSpinBox or QDoubleSpinBox that explains rejected input in a sentence under the field. A letter is ignored, and a
/// number out of range is replaced by the nearest permitted number. Accepts a comma or a point before decimals.
template <class SpinBox>
class NumberBox : public SpinBox {
  using Value = decltype(std::declval<SpinBox>().value());

 public:
  /// `name` is the beginning of each sentence.
  explicit NumberBox(const QString& name, QWidget* parent = nullptr) : SpinBox(parent), name_(name) {
    QObject::connect(this->lineEdit(), &QLineEdit::inputRejected, this,
                     [this] { tell(said("%1 takes a number from %2 to %3.").arg(name_, least(), most())); });
  }

  QValidator::State validate(QString& input, int&) const override {
    const QString number = bare(input);
    if (number.isEmpty() || number == QLatin1String("+")) return QValidator::Intermediate;
    if (number == QLatin1String("-")) return this->minimum() < 0 ? QValidator::Intermediate : QValidator::Invalid;
    bool isNumber = false;
    const double value = number.toDouble(&isNumber);
    if (!isNumber || !std::isfinite(value)) return QValidator::Invalid;
    return value < this->minimum() || value > this->maximum() ? QValidator::Intermediate : QValidator::Acceptable;
  }

  /// Corrects an input when the user has finished typing.
  void fixup(QString& input) const override {
    bool isNumber = false;
    const double value = bare(input).toDouble(&isNumber);
    if (!isNumber) return;
    tell(said("%1 must be from %2 to %3; %4 is outside this range.").arg(name_, least(), most(), input.trimmed()));
    input = words(std::clamp(value, double(this->minimum()), double(this->maximum())));
  }

  Value valueFromText(const QString& text) const override {
    const double value = bare(text).toDouble();
    return std::is_integral_v<Value> ? Value(std::lround(value)) : Value(value);
  }

 private:
  static QString said(const char* words) { return QCoreApplication::translate("NumberBox", words); }
  QString words(double value) const { return this->textFromValue(Value(value)) + this->suffix(); }
  QString bare(QString text) const {
    if (!this->suffix().isEmpty()) text.remove(this->suffix().trimmed());
    return text.trimmed().replace(QLatin1Char(','), QLatin1Char('.'));
  }
  QString least() const { return words(this->minimum()); }
  QString most() const { return words(this->maximum()); }
  void tell(const QString& sentence) const {
    QToolTip::showText(this->mapToGlobal({0, this->height()}), sentence, const_cast<NumberBox*>(this));
  }

  QString name_;
};

}  // namespace insonate::ui
