#include "KeptSignIn.h"

#include "PrivateJson.h"

#include <insonate/curriculum/PeopleStore.h>

#include <QJsonObject>
#include <system_error>

namespace insonate::ui {
namespace {

namespace fs = std::filesystem;

const QString kKeptName = QStringLiteral("name"), kToken = QStringLiteral("token"),
              kPassword = QStringLiteral("password");

}  // namespace

KeptSignIn readKeptSignIn(const fs::path& file) {
  const QJsonObject json = readPrivateJson(file);
  const auto text = [&json](const QString& key) { return json[key].toString().toStdString(); };
  return {text(kKeptName), text(kToken), text(kPassword)};
}

Result<void> writeKeptSignIn(const fs::path& file, const KeptSignIn& kept) {
  const auto text = [](const std::string& value) { return QString::fromStdString(value); };
  QJsonObject json{{kKeptName, text(kept.name)}};
  if (!kept.token.empty()) json[kToken] = text(kept.token);
  if (!kept.generatedPassword.empty()) json[kPassword] = text(kept.generatedPassword);
  return writePrivateJson(file, json);
}

Result<void> keepSignedIn(const fs::path& file, const SignedIn& by) {
  const auto token = PeopleStore(by).staySignedIn();
  if (!token) return tl::unexpected(token.error());
  return writeKeptSignIn(file, {.name = by.person().name, .token = *token});
}

void removeKeptSignIn(const fs::path& file) {
  std::error_code error;
  fs::remove(file, error);
}

}  // namespace insonate::ui
