#include "KeptSignIn.h"

#include <insonate/core/AtomicFile.h>
#include <insonate/curriculum/PeopleStore.h>

#include <QByteArray>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <fstream>
#include <system_error>

namespace insonate::ui {
namespace {

namespace fs = std::filesystem;

const QString kKeptName = QStringLiteral("name"), kToken = QStringLiteral("token"),
              kPassword = QStringLiteral("password");

}  // namespace

KeptSignIn readKeptSignIn(const fs::path& file) {
  QFile stream(QString::fromStdString(file.string()));
  if (!stream.open(QIODevice::ReadOnly)) return {};
  const QJsonObject json = QJsonDocument::fromJson(stream.readAll()).object();
  const auto text = [&json](const QString& key) { return json[key].toString().toStdString(); };
  return {text(kKeptName), text(kToken), text(kPassword)};
}

Result<void> writeKeptSignIn(const fs::path& file, const KeptSignIn& kept) {
  const auto text = [](const std::string& value) { return QString::fromStdString(value); };
  QJsonObject json{{kKeptName, text(kept.name)}};
  if (!kept.token.empty()) json[kToken] = text(kept.token);
  if (!kept.generatedPassword.empty()) json[kPassword] = text(kept.generatedPassword);
  const QByteArray bytes = QJsonDocument(json).toJson();
  return writeAtomically(file, [&bytes](const fs::path& beside) -> Result<void> {
    std::ofstream stream(beside, std::ios::binary);
    std::error_code error;
    fs::permissions(beside, fs::perms::owner_read | fs::perms::owner_write, error);
    if (error || !stream.write(bytes.data(), bytes.size()).flush())
      return fail("Could not write " + beside.string() + ".");
    return {};
  });
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
