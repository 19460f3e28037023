#include "store/Texts.h"

#include <nlohmann/json.hpp>
#include <sodium.h>

#include <QtCore/QDateTime>
#include <QtCore/QString>
#include <QtCore/QUuid>
#include <QtCore/QVector>
#include <algorithm>
#include <array>
#include <optional>

namespace insonate::store {
namespace {

constexpr std::size_t kMaxName = 64, kMaxTitle = 200, kMaxJson = 1'000'000;
// NIST SP 800-63B requires at least 8 characters.
constexpr int kMinPassword = 8, kMaxPassword = 200;

QString words(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<int>(text.size()));
}

/// Unicode's embeddings, overrides and isolates, which change the direction of the text beside them.
bool turnsDirection(uint letter) {
  return (letter >= 0x202a && letter <= 0x202e) || (letter >= 0x2066 && letter <= 0x2069);
}

bool isUnprintable(uint letter) {
  const auto category = QChar::category(letter);
  return category == QChar::Other_Control || category == QChar::Separator_Line ||
         category == QChar::Separator_Paragraph || QChar::isNonCharacter(letter) || turnsDirection(letter);
}

bool isForSignIn(uint letter) {
  return QChar::isLetterOrNumber(letter) || QChar::isMark(letter) ||
         (letter < 128 && std::string_view("._-+@").find(static_cast<char>(letter)) != std::string_view::npos);
}

}  // namespace

Result<void> checkText(std::string_view what, std::string_view text, std::size_t bytes) {
  const std::string name(what);
  if (text.size() > bytes)
    return fail(name + " is " + std::to_string(text.size()) + " bytes long. The maximum is " + std::to_string(bytes) +
                ". Shorten it.");
  if (text.find('\0') != std::string_view::npos) return fail(name + " holds a zero byte; remove it.");
  if (words(text).toUtf8() != QByteArray::fromRawData(text.data(), static_cast<int>(text.size())))
    return fail(name + " is not UTF-8; save or type it as Unicode.");
  return {};
}

Result<void> checkTitle(std::string_view what, std::string_view text) {
  if (auto ok = checkText(what, text, 4 * kMaxTitle); !ok) return ok;
  const QVector<uint> letters = words(text).toUcs4();
  if (static_cast<std::size_t>(letters.size()) > kMaxTitle)
    return fail(std::string(what) + " is longer than " + std::to_string(kMaxTitle) + " letters; shorten it.");
  if (std::any_of(letters.begin(), letters.end(), isUnprintable))
    return fail(std::string(what) + " contains a line break or another invisible character. Type it again.");
  return {};
}

Result<void> checkSignInName(std::string_view name) {
  if (auto ok = checkText("The sign-in name", name, 4 * kMaxName); !ok) return ok;
  const QVector<uint> letters = words(name).toUcs4();
  if (letters.isEmpty() || static_cast<std::size_t>(letters.size()) > kMaxName ||
      !std::all_of(letters.begin(), letters.end(), isForSignIn))
    return fail("A sign-in name has 1 to 64 letters, digits and . _ - + @, and no spaces; choose another.");
  std::optional<QChar::Script> script;
  for (const uint letter : letters) {
    const QChar::Script own = QChar::script(letter);
    if (own == QChar::Script_Common || own == QChar::Script_Inherited) continue;
    if (script && *script != own)
      return fail("The sign-in name mixes letters of two alphabets that look alike. Type it with one keyboard layout.");
    script = own;
  }
  return {};
}

Result<void> checkEmail(std::string_view email) {
  if (email.empty()) return {};
  if (auto ok = checkTitle("The e-mail address", email); !ok) return ok;
  const std::size_t at = email.find('@');
  if (at == 0 || at == std::string_view::npos || at + 1 == email.size() || email.find(' ') != std::string_view::npos)
    return fail("'" + std::string(email) + "' is not an e-mail address. Write it as NAME@DOMAIN, or leave it empty.");
  return {};
}

Result<void> checkPassword(std::string_view password) {
  if (auto ok = checkText("The password", password, 4 * kMaxPassword); !ok) return ok;
  const auto length = words(password).toUcs4().size();
  if (length < kMinPassword || length > kMaxPassword)
    return fail("A password has 8 to 200 characters; choose another, a sentence for instance.");
  return {};
}

Result<void> checkJsonObject(std::string_view what, std::string_view text) {
  if (auto ok = checkText(what, text, kMaxJson); !ok) return ok;
  using nlohmann::json;
  bool hasZero = false;
  const auto look = [&hasZero](int, json::parse_event_t, const json& value) {
    hasZero = hasZero || (value.is_string() && value.get_ref<const std::string&>().find('\0') != std::string::npos);
    return true;
  };
  const bool isObject = json::parse(text, look, false).is_object();
  if (hasZero) return fail(std::string(what) + " hold a zero byte (\\u0000) in a text; remove it.");
  if (!isObject) return fail(std::string(what) + " is not a JSON object; check it with the program that wrote it.");
  return {};
}

std::string nameKey(std::string_view name) {
  return words(name)
      .normalized(QString::NormalizationForm_KC)
      .toCaseFolded()
      .normalized(QString::NormalizationForm_KC)
      .toStdString();
}

std::string freshUuid() {
  return QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
}

bool isUuid(std::string_view text) {
  const QUuid uuid = QUuid::fromString(words(text));
  return !uuid.isNull() && uuid.toString(QUuid::WithoutBraces).toStdString() == text;
}

std::string dayOf(std::int64_t time_us) {
  return QDateTime::fromMSecsSinceEpoch(time_us / 1000, Qt::UTC).toString(QStringLiteral("yyyy-MM-dd")).toStdString();
}

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, crypto_hash_sha256_BYTES> hash{};
  crypto_hash_sha256(hash.data(), reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  std::array<char, 2 * crypto_hash_sha256_BYTES + 1> digits{};
  return sodium_bin2hex(digits.data(), digits.size(), hash.data(), hash.size());
}

}  // namespace insonate::store
