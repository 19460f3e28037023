#pragma once

#include <QtCore/QString>
#include <QtCore/QVariant>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace insonate::store {

/// Converts a value to the form in which it is bound to an SQL statement: truth values are 0 or 1, an empty optional is
/// NULL.
inline QVariant bound(std::string_view text) {
  if (text.empty()) return QVariant(QString(""));  // an empty text is not NULL
  // Texts to be stored were checked before; a zero byte in a search text would end the statement on its way to a
  // server.
  return QVariant(
      QString::fromUtf8(text.data(), static_cast<int>(text.size())).replace(QChar('\0'), QChar::ReplacementCharacter));
}
inline QVariant bound(const char* text) {
  return bound(std::string_view(text));
}
inline QVariant bound(const std::string& text) {
  return bound(std::string_view(text));
}
inline QVariant bound(std::int64_t number) {
  return QVariant(static_cast<qlonglong>(number));
}
inline QVariant bound(int number) {
  return QVariant(static_cast<qlonglong>(number));
}
inline QVariant bound(bool truth) {
  return QVariant(static_cast<qlonglong>(truth ? 1 : 0));
}
inline QVariant bound(const std::optional<double>& number) {
  return number ? QVariant(*number) : QVariant(QVariant::Double);
}
inline QVariant bound(const std::optional<std::int64_t>& number) {
  return number ? bound(*number) : QVariant(QVariant::LongLong);
}
inline QVariant bound(const std::optional<std::string>& text) {
  return text ? bound(*text) : QVariant(QVariant::String);
}

/// One row of the result of an SQL statement; values are accessed by column number.
class Row {
 public:
  explicit Row(std::vector<QVariant> values) : values_(std::move(values)) {}

  std::string text(std::size_t column) const { return values_[column].toString().toStdString(); }
  std::int64_t number(std::size_t column) const { return values_[column].toLongLong(); }
  int count(std::size_t column) const { return static_cast<int>(number(column)); }
  bool truth(std::size_t column) const { return number(column) != 0; }
  bool isNull(std::size_t column) const { return values_[column].isNull(); }
  std::optional<double> real(std::size_t column) const {
    return isNull(column) ? std::nullopt : std::optional(values_[column].toDouble());
  }
  std::optional<std::int64_t> time(std::size_t column) const {
    return isNull(column) ? std::nullopt : std::optional(number(column));
  }
  std::size_t size() const { return values_.size(); }
  const QVariant& value(std::size_t column) const { return values_[column]; }

 private:
  std::vector<QVariant> values_;
};

}  // namespace insonate::store
