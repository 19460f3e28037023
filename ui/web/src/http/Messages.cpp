#include "http/Messages.h"

#include <sodium.h>

#include <QString>
#include <QUrl>
#include <algorithm>

namespace insonate::web {
namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// Calls take(name, value) for each NAME=VALUE between separators.
template <class Take>
void split(std::string_view text, char separator, const Take& take) {
  while (!text.empty()) {
    const std::string_view one = text.substr(0, text.find(separator));
    text.remove_prefix(std::min(text.size(), one.size() + 1));
    if (const std::size_t equals = one.find('='); equals != std::string_view::npos)
      take(one.substr(0, equals), one.substr(equals + 1));
  }
}

}  // namespace

const std::string& valueOf(const Fields& fields, std::string_view name) {
  static const std::string kNone;
  const auto found = fields.find(name);
  return found == fields.end() ? kNone : found->second;
}

std::string plainText(const std::string& bytes) {
  QString clean;
  for (const QChar c : QString::fromStdString(bytes)) {
    const bool isControl = c.category() == QChar::Other_Control && c != QLatin1Char('\n') && c != QLatin1Char('\t');
    if (!isControl && c != QChar(QChar::ReplacementCharacter)) clean += c;
  }
  return clean.toStdString();
}

std::string decoded(std::string_view text, bool plusIsSpace) {
  QByteArray bytes(text.data(), static_cast<int>(text.size()));
  if (plusIsSpace) bytes.replace('+', ' ');
  return plainText(QByteArray::fromPercentEncoding(bytes).toStdString());
}

std::string encoded(std::string_view text) {
  return QUrl::toPercentEncoding(QString::fromUtf8(text.data(), static_cast<int>(text.size()))).toStdString();
}

Fields fieldsOfForm(std::string_view text) {
  Fields fields;
  split(text, '&', [&](std::string_view name, std::string_view value) {
    fields.emplace(decoded(name, true), decoded(value, true));
  });
  return fields;
}

Fields fieldsOfCookies(std::string_view text) {
  Fields fields;
  split(text, ';',
        [&](std::string_view name, std::string_view value) { fields.emplace(trimmed(name), trimmed(value)); });
  return fields;
}

bool areEqual(const std::string& expected, const std::string& given) {
  return expected.size() == given.size() && sodium_memcmp(expected.data(), given.data(), expected.size()) == 0;
}

}  // namespace insonate::web
